//! Texts that were typed, each for something.

use std::borrow::Borrow;

/// Texts by what they were typed for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typed<K>(pub Vec<(K, String)>);

impl<K> Default for Typed<K> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K> Typed<K> {
    /// The text that was typed for a key; empty where none was.
    pub fn text<Q: PartialEq + ?Sized>(&self, key: &Q) -> &str
    where
        K: Borrow<Q>,
    {
        self.0.iter().find(|(known, _)| known.borrow() == key).map_or("", |(_, text)| text)
    }

    /// Takes a text for a key.
    pub fn set<Q: PartialEq + ToOwned<Owned = K> + ?Sized>(&mut self, key: &Q, text: String)
    where
        K: Borrow<Q>,
    {
        match self.0.iter_mut().find(|(known, _)| (*known).borrow() == key) {
            Some((_, old)) => *old = text,
            None => self.0.push((key.to_owned(), text)),
        }
    }
}
