//! A shaft element in one plane: deflections and slopes of its two ends, `(x₁, φ₁, x₂, φ₂)`.
//!
//! Stiffness comes from the flexibility of the element as a cantilever, which is exact for a taper too; inertia from
//! the cubic shape functions of a Timoshenko beam, exact for a uniform element at rest. Friswell et al., *Dynamics of
//! Rotating Machines*, §5.4; Cowper, J. Appl. Mech. 33 (1966) 335–340, for the shear factor.

use nalgebra::{Matrix2, Matrix2x4, Matrix4, Vector4};

use super::RotorError;
use crate::section;

/// A piece of shaft between two nodes, its diameters linear from left to right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftElement {
    /// Length, m.
    pub length: f64,
    /// Outer diameters at the left and at the right, m.
    pub outer: [f64; 2],
    /// Inner diameters at the left and at the right, m; zero for a solid shaft.
    pub inner: [f64; 2],
    /// Material of the element.
    pub material: Material,
}

/// Material of a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus, Pa.
    pub young: f64,
    /// Shear modulus, Pa.
    pub shear: f64,
    /// Density, kg/m³.
    pub density: f64,
    /// Internal viscous damping `ηᵥ`, s: stress `E (ε + ηᵥ ε̇)`.
    pub viscous_damping: f64,
    /// Loss factor `ηₕ` of internal hysteretic damping.
    pub loss_factor: f64,
}

/// Beam theory: Euler–Bernoulli or Timoshenko.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum BeamTheory {
    /// Bending and shear, with Cowper's shear factor.
    #[default]
    Timoshenko,
    /// Bending alone; rotary inertia is counted all the same.
    EulerBernoulli,
}

/// The matrices of an element in one plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Matrices {
    /// Mass with rotary inertia.
    pub mass: Matrix4<f64>,
    /// Polar inertia on the slopes: half of the gyroscopic matrix between the planes.
    pub gyroscopic: Matrix4<f64>,
    /// Stiffness of the material, without tension.
    pub elastic: Matrix4<f64>,
    /// The same on the two deformations of the element alone, see [`deformations`].
    pub bending: Matrix2<f64>,
    /// Stiffness of a tension of 1 N.
    pub geometric: Matrix4<f64>,
}

/// Cowper's shear factor of a round tube, `m` the ratio of its inner to its outer diameter:
/// `κ = 6(1 + ν)(1 + m²)²/((7 + 6ν)(1 + m²)² + (20 + 12ν)m²)`.
pub fn shear_factor(poisson: f64, ratio: f64) -> f64 {
    let square = ratio.powi(2);
    let sum = (1.0 + square).powi(2);
    6.0 * (1.0 + poisson) * sum / ((7.0 + 6.0 * poisson) * sum + (20.0 + 12.0 * poisson) * square)
}

/// The matrices of an element.
///
/// # Errors
/// `Value` where a length, diameter, modulus or density makes no shaft.
pub fn matrices(element: &ShaftElement, theory: BeamTheory) -> Result<Matrices, RotorError> {
    let ShaftElement { length, outer, inner, material } = *element;
    positive("the length of an element", length)?;
    positive("Young's modulus", material.young)?;
    positive("the density", material.density)?;
    for end in [0, 1] {
        positive("an outer diameter", outer[end])?;
        positive("the wall of the shaft", outer[end] - inner[end])?;
    }
    let shear = match theory {
        BeamTheory::Timoshenko => {
            positive("the shear modulus", material.shear)?;
            material.shear
        }
        BeamTheory::EulerBernoulli => f64::INFINITY,
    };
    let poisson = material.young / (2.0 * material.shear) - 1.0;
    let at = |share: f64| {
        let mix = |ends: [f64; 2]| ends[0] + share * (ends[1] - ends[0]);
        let (outer, inner) = (mix(outer), mix(inner));
        let area = section::tube_area(outer, inner);
        let moment = section::tube_second_moment(outer, inner);
        let sheared =
            if shear.is_finite() { 1.0 / (shear_factor(poisson, inner / outer) * shear * area) } else { 0.0 };
        (area, moment, sheared)
    };

    // Flexibility under a shear force and the bending moment at the middle. About the middle nothing cancels.
    let mut flexibility = [0.0; 3];
    for (share, weight) in gauss() {
        let (_, moment, sheared) = at(share);
        let (lever, weight) = (length * (0.5 - share), weight * length);
        let bend = weight / (material.young * moment);
        flexibility[0] += bend * lever.powi(2) + weight * sheared;
        flexibility[1] += bend * lever;
        flexibility[2] += bend;
    }
    let [f, g, h] = flexibility;
    let bending = Matrix2::new(h, -g, -g, f) / (f * h - g * g);
    let deformations = deformations(length);
    let elastic = deformations.transpose() * bending * deformations;

    // Shear over bending flexibility of the mean section, Φ = 12EI/(κGAL²).
    let (_, moment, sheared) = at(0.5);
    let phi = 12.0 * material.young * moment * sheared / length.powi(2);
    let (mut mass, mut gyroscopic, mut geometric) = (Matrix4::zeros(), Matrix4::zeros(), Matrix4::zeros());
    for (share, weight) in gauss() {
        let (area, moment, _) = at(share);
        let shape = Shape::at(share, length, phi);
        let weight = weight * length;
        let rotary = shape.slope * shape.slope.transpose() * (material.density * moment * weight);
        mass += shape.deflection * shape.deflection.transpose() * (material.density * area * weight) + rotary;
        gyroscopic += rotary * 2.0;
        geometric += shape.gradient * shape.gradient.transpose() * weight;
    }
    let all = [mass, gyroscopic, elastic, geometric];
    if all.iter().flat_map(|matrix| matrix.iter()).all(|x| x.is_finite()) {
        Ok(Matrices { mass, gyroscopic, elastic, bending, geometric })
    } else {
        Err(RotorError::Value { what: "a matrix of the shaft", value: f64::INFINITY })
    }
}

/// Matrix from the end motions `(x₁, φ₁, x₂, φ₂)` of an element to its two deformations: the deflection of one end
/// relative to the other beyond the mean slope, and the difference of the slopes. A rigid motion has none.
pub fn deformations(length: f64) -> Matrix2x4<f64> {
    Matrix2x4::new(-1.0, -length / 2.0, 1.0, -length / 2.0, 0.0, -1.0, 0.0, 1.0)
}

pub(super) fn positive(what: &'static str, value: f64) -> Result<(), RotorError> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(RotorError::Value { what, value }) }
}

/// Shape functions at a share of the length.
struct Shape {
    deflection: Vector4<f64>,
    slope: Vector4<f64>,
    gradient: Vector4<f64>,
}

impl Shape {
    fn at(s: f64, length: f64, phi: f64) -> Self {
        let c = 1.0 / (1.0 + phi);
        let (s2, s3) = (s * s, s * s * s);
        Self {
            deflection: Vector4::new(
                1.0 - 3.0 * s2 + 2.0 * s3 + phi * (1.0 - s),
                length * (s - 2.0 * s2 + s3 + phi / 2.0 * (s - s2)),
                3.0 * s2 - 2.0 * s3 + phi * s,
                length * (s3 - s2 + phi / 2.0 * (s2 - s)),
            ) * c,
            slope: Vector4::new(
                6.0 * (s2 - s) / length,
                1.0 - 4.0 * s + 3.0 * s2 + phi * (1.0 - s),
                6.0 * (s - s2) / length,
                3.0 * s2 - 2.0 * s + phi * s,
            ) * c,
            gradient: Vector4::new(
                (6.0 * (s2 - s) - phi) / length,
                1.0 - 4.0 * s + 3.0 * s2 + phi / 2.0 * (1.0 - 2.0 * s),
                (6.0 * (s - s2) + phi) / length,
                3.0 * s2 - 2.0 * s + phi / 2.0 * (2.0 * s - 1.0),
            ) * c,
        }
    }
}

/// Abscissas and weights of the five-point Gauss rule on `[0, 1]`, exact to degree nine.
fn gauss() -> [(f64, f64); 5] {
    let root = (10.0f64 / 7.0).sqrt();
    let near = (5.0 - 2.0 * root).sqrt() / 3.0;
    let far = (5.0 + 2.0 * root).sqrt() / 3.0;
    let (heavy, light) = ((322.0 + 13.0 * 70f64.sqrt()) / 900.0, (322.0 - 13.0 * 70f64.sqrt()) / 900.0);
    [(-far, light), (-near, heavy), (0.0, 128.0 / 225.0), (near, heavy), (far, light)]
        .map(|(x, weight)| (0.5 + x / 2.0, weight / 2.0))
}
