//! Vectors in space over SIMD vectors.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Vector3;

use super::SimdVector;
use crate::{Real, Vector};

/// A vector in space over SIMD vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimdVector3(pub [SimdVector; 3]);

macro_rules! component_by_component {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl $trait for SimdVector3 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ([x, y, z], [a, b, c]) = (self.0, other.0);
                Self([x $op a, y $op b, z $op c])
            }
        }
    )*};
}

component_by_component!(Add add +, Sub sub -);

macro_rules! by_a_scalar {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl $trait<SimdVector> for SimdVector3 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, scalar: SimdVector) -> Self {
                let [x, y, z] = self.0;
                Self([x $op scalar, y $op scalar, z $op scalar])
            }
        }
    )*};
}

by_a_scalar!(Mul mul *, Div div /);

impl Neg for SimdVector3 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let [x, y, z] = self.0;
        Self([-x, -y, -z])
    }
}

/// The order of operations is that of nalgebra's vectors.
impl Vector for SimdVector3 {
    type Scalar = SimdVector;
    #[inline(always)]
    fn from_components(x: SimdVector, y: SimdVector, z: SimdVector) -> Self {
        Self([x, y, z])
    }
    #[inline(always)]
    fn components(self) -> [SimdVector; 3] {
        self.0
    }
    #[inline(always)]
    fn value(self) -> Vector3<f64> {
        self.0.map(Real::value).into()
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.0.into_iter().all(|component| component.holds(|x| x == 0.0))
    }
    #[inline(always)]
    fn dot(self, other: Self) -> SimdVector {
        let ([x, y, z], [a, b, c]) = (self.0, other.0);
        x * a + y * b + z * c
    }
    #[inline(always)]
    fn cross(self, other: Self) -> Self {
        let ([x, y, z], [a, b, c]) = (self.0, other.0);
        Self([y * c - z * b, z * a - x * c, x * b - y * a])
    }
    #[inline(always)]
    fn magnitude(self) -> SimdVector {
        self.dot(self).sqrt()
    }
    #[inline(always)]
    fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let mut sum = Self([SimdVector::from(0.0); 3]);
        for term in terms {
            sum = sum + term;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::WIDTH;

    #[test]
    fn vectors_in_space_are_those_of_every_lane() {
        let of = |k: f64| [0.3, -1.7, 2.9].map(|c| SimdVector::of(|lane| c * k + 0.1 * lane as f64));
        let lane = |v: SimdVector3, lane: usize| Vector3::from(v.0.map(|c| c.0[lane]));
        let (a, b, k) = (SimdVector3(of(1.0)), SimdVector3(of(-0.6)), of(2.0)[0]);
        for at in 0..WIDTH {
            let (x, y, s) = (lane(a, at), lane(b, at), k.0[at]);
            assert_eq!(a.dot(b).0[at], Vector::dot(x, y));
            assert_eq!(a.magnitude().0[at], Vector::magnitude(x));
            assert_eq!(lane(a.cross(b), at), Vector::cross(x, y));
            assert_eq!(lane(a + b, at), x + y);
            assert_eq!(lane(a - b, at), x - y);
            assert_eq!(lane(-a, at), -x);
            assert_eq!(lane(a * k, at), x * s);
            assert_eq!(lane(a / k, at), x / s);
            assert_eq!(lane(Vector::sum([a, b, a]), at), <Vector3<f64> as Vector>::sum([x, y, x]));
        }
    }
}
