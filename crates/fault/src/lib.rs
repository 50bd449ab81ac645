//! Faults: what is wrong, where, and what would be valid; and RON read with its places.
