//! What is being done.

/// Is told what is being done.
pub trait Progress: Send {
    /// A new piece of work begins.
    fn stage(&mut self, what: String);

    /// One of many like pieces of work begins.
    fn repeated(&mut self, what: String);

    /// This share of a longer piece of work is done, from 0 to 1.
    fn share(&mut self, what: &str, done: f32);
}
