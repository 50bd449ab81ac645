//! Pass graphs: RON in, a checked plan out. No GPU.
