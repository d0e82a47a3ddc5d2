//! Shapes of drawings and of animations, drawn when they are first read.

use std::{
    fmt,
    ops::Deref,
    sync::{Arc, LazyLock},
};

use dalembert_units::UnitSystem;

use crate::DrawnShape;

/// Value that is computed when it is first read; copies share it.
///
/// A solve makes all drawings of a problem, of which a screen shows one and a sweep none, so their shapes and the places
/// of their letters are found when they are first shown.
#[derive(Clone)]
pub struct Deferred<T>(Arc<LazyValue<T>>);

type LazyValue<T> = LazyLock<T, Box<dyn FnOnce() -> T + Send + Sync>>;

impl<T: Send + Sync + 'static> Deferred<T> {
    /// A value by the function that computes it.
    pub fn new(compute: impl FnOnce() -> T + Send + Sync + 'static) -> Self {
        Self(Arc::new(LazyLock::new(Box::new(compute))))
    }
}

impl Deferred<Vec<DrawnShape>> {
    /// The same shapes with every number of their words in the unit of a system.
    pub(super) fn shown_in(&self, system: UnitSystem) -> Self {
        let shapes = self.clone();
        Self::new(move || shown_in(&shapes, system))
    }
}

fn shown_in(shapes: &[DrawnShape], system: UnitSystem) -> Vec<DrawnShape> {
    let one = |shape: &DrawnShape| match shape {
        DrawnShape::Label(at, side, words) => {
            let mut words = words.clone();
            words.show_in(system);
            DrawnShape::Label(*at, *side, words)
        }
        other => other.clone(),
    };
    shapes.iter().map(one).collect()
}

impl<T: Send + Sync + 'static> From<T> for Deferred<T> {
    fn from(value: T) -> Self {
        let deferred = Self::new(|| value);
        LazyLock::force(&deferred.0);
        deferred
    }
}

impl<T> Deref for Deferred<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T: PartialEq> PartialEq for Deferred<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || **self == **other
    }
}

impl<T: fmt::Debug> fmt::Debug for Deferred<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// Frames of an animation: the shapes of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Frames {
    count: usize,
    shapes: Deferred<Vec<Vec<DrawnShape>>>,
}

impl Frames {
    /// So many frames, with what draws them all.
    pub fn new(count: usize, draw: impl FnOnce() -> Vec<Vec<DrawnShape>> + Send + Sync + 'static) -> Self {
        Self { count, shapes: Deferred::new(draw) }
    }

    /// The same frames with every number of their words in the unit of a system.
    pub(super) fn shown_in(&self, system: UnitSystem) -> Self {
        let shapes = self.shapes.clone();
        Self::new(self.count, move || shapes.iter().map(|frame| shown_in(frame, system)).collect())
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
