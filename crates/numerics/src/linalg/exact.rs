//! Sums of products with twice the digits, for what is left where almost everything cancels.

/// The sum of products, with the error of each operation carried along (Dot2 of Ogita, Rump and Oishi).
#[derive(Clone, Copy, Default)]
pub(super) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    pub(super) fn add(&mut self, term: f64) {
        let sum = self.high + term;
        let part = sum - self.high;
        self.low += (self.high - (sum - part)) + (term - part);
        self.high = sum;
    }

    pub(super) fn add_product(&mut self, x: f64, y: f64) {
        let (product, error) = product(x, y);
        self.add(product);
        self.low += error;
    }

    pub(super) fn value(self) -> f64 {
        self.high + self.low
    }

    /// The sum as a number and its remainder.
    pub(super) fn parts(self) -> (f64, f64) {
        let high = self.high + self.low;
        (high, (self.high - high) + self.low)
    }
}

/// A product and what rounding took from it (Dekker); for sizes well inside the range of numbers.
fn product(x: f64, y: f64) -> (f64, f64) {
    let split = |x: f64| {
        let large = x * 134_217_729.0;
        let high = large - (large - x);
        (high, x - high)
    };
    let product = x * y;
    let ((a, b), (c, d)) = (split(x), split(y));
    (product, b * d - (((product - a * c) - b * c) - a * d))
}
