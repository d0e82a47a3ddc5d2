//! Numbers with their first and second derivative by the time: every formula over `Real` read with them is its own
//! differentiation.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dalembert_mechanics::Real;

/// `x`, `ẋ`, `ẍ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet(pub [f64; 3]);

impl Jet {
    /// A function of a jet by its value and first two derivatives there.
    fn through(self, [f, first, second]: [f64; 3]) -> Self {
        let Jet([_, v, a]) = self;
        Jet([f, first * v, first * a + second * v * v])
    }
}

impl From<f64> for Jet {
    fn from(x: f64) -> Self {
        Jet([x, 0.0, 0.0])
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        Jet([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }
}

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        Jet(self.0.map(|x| -x))
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        let (Jet([x, v, a]), Jet([y, w, b])) = (self, other);
        Jet([x * y, v * y + x * w, a * y + 2.0 * v * w + x * b])
    }
}

impl Div for Jet {
    type Output = Jet;
    fn div(self, other: Jet) -> Jet {
        let y = other.0[0];
        self * other.through([1.0 / y, -1.0 / (y * y), 2.0 / (y * y * y)])
    }
}

macro_rules! with_literals {
    ($($operator:ident $function:ident),*) => {
        $(impl $operator<f64> for Jet {
            type Output = Jet;
            fn $function(self, other: f64) -> Jet {
                self.$function(Jet::from(other))
            }
        })*
    };
}

with_literals!(Add add, Sub sub, Mul mul, Div div);

impl Real for Jet {
    fn value(self) -> f64 {
        self.0[0]
    }
    fn powi(self, n: i8) -> Jet {
        let (x, n) = (self.0[0], i32::from(n));
        let power = |less: i32| if n < less && n >= 0 { 0.0 } else { x.powi(n - less) };
        let n_f = f64::from(n);
        self.through([x.powi(n), n_f * power(1), n_f * (n_f - 1.0) * power(2)])
    }
    fn root(self, n: u8) -> Jet {
        let (x, p) = (self.0[0], 1.0 / f64::from(n));
        self.through([x.powf(p), p * x.powf(p - 1.0), p * (p - 1.0) * x.powf(p - 2.0)])
    }
    fn abs(self) -> Jet {
        if self.0[0] < 0.0 { -self } else { self }
    }
    fn sin(self) -> Jet {
        let (s, c) = self.0[0].sin_cos();
        self.through([s, c, -s])
    }
    fn cos(self) -> Jet {
        let (s, c) = self.0[0].sin_cos();
        self.through([c, -s, -c])
    }
    fn tan(self) -> Jet {
        self.sin() / self.cos()
    }
    fn asin(self) -> Jet {
        let x = self.0[0];
        let root = (1.0 - x * x).sqrt();
        self.through([x.asin(), 1.0 / root, x / root.powi(3)])
    }
    fn acos(self) -> Jet {
        -self.asin() + std::f64::consts::FRAC_PI_2
    }
    fn atan2(self, x: Jet) -> Jet {
        let angle = f64::atan2(self.0[0], x.0[0]);
        let size = x * x + self * self;
        // The first derivative as a jet of its own gives the second.
        let [y, w, b] = self.0;
        let [u, v, a] = x.0;
        let first = (w * u - y * v) / size.0[0];
        let second = (b * u - y * a) / size.0[0] - first * size.0[1] / size.0[0];
        Jet([angle, first, second])
    }
    fn exp(self) -> Jet {
        let e = self.0[0].exp();
        self.through([e, e, e])
    }
    fn ln(self) -> Jet {
        let x = self.0[0];
        self.through([x.ln(), 1.0 / x, -1.0 / (x * x)])
    }
    fn log10(self) -> Jet {
        self.ln() / std::f64::consts::LN_10
    }
    fn sinh(self) -> Jet {
        let (s, c) = (self.0[0].sinh(), self.0[0].cosh());
        self.through([s, c, s])
    }
    fn cosh(self) -> Jet {
        let (s, c) = (self.0[0].sinh(), self.0[0].cosh());
        self.through([c, s, c])
    }
    fn tanh(self) -> Jet {
        self.sinh() / self.cosh()
    }
    fn pow(self, exponent: Jet) -> Jet {
        (self.ln() * exponent).exp()
    }
    fn min(self, other: Jet) -> Jet {
        if other.0[0] < self.0[0] { other } else { self }
    }
    fn max(self, other: Jet) -> Jet {
        if other.0[0] > self.0[0] { other } else { self }
    }
    fn sum(terms: impl IntoIterator<Item = Jet>) -> Jet {
        terms.into_iter().fold(Jet::from(0.0), Add::add)
    }
}
