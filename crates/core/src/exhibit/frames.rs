//! Frames of an animation, drawn when they are first read.

use std::{
    fmt,
    ops::Deref,
    sync::{Arc, LazyLock},
};

use crate::DrawnShape;

/// Frames of an animation: the shapes of each.
///
/// A solve makes all animations of a problem, of which a screen shows one, so shapes are drawn when they are first read.
/// Copies share what was drawn.
#[derive(Clone)]
pub struct Frames {
    count: usize,
    shapes: Arc<LazyShapes>,
}

type LazyShapes = LazyLock<Vec<Vec<DrawnShape>>, Box<dyn FnOnce() -> Vec<Vec<DrawnShape>> + Send + Sync>>;

impl Frames {
    /// So many frames, with what draws them all.
    pub fn new(count: usize, draw: impl FnOnce() -> Vec<Vec<DrawnShape>> + Send + Sync + 'static) -> Self {
        Self { count, shapes: Arc::new(LazyLock::new(Box::new(draw))) }
    }

    /// Number of frames; none is drawn for it.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns true if there is no frame.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl Deref for Frames {
    type Target = [Vec<DrawnShape>];

    fn deref(&self) -> &Self::Target {
        &self.shapes
    }
}

impl PartialEq for Frames {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

impl fmt::Debug for Frames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
