//! An attitude as a user gives it, and the rows of `[BN]`.

use dalembert_core::{Inputs, Reason, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};

use super::{
    euler::EulerSequence,
    observations::{VectorObservation, by_observations},
    rotations::{
        by_axis, by_parameters, check_length, matrix, off_cayley_formula, off_rotation, row_steps, row_times,
        rows,
    },
};
use crate::sources::SCHAUB;

/// Axes of one of the two frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum FrameAxes {
    /// N: fixed
    Fixed,
    /// B: of the body
    Body,
}

/// Attitude of a frame B in a frame N.
#[derive(Clone, Debug, Inputs)]
pub enum AttitudeInput {
    /// One attitude
    #[input(flatten)]
    One(SingleAttitude),
    /// Successive rotations
    /// In order from N: each is of the frame that the one before it left. Their matrices are multiplied from the left.
    Successive {
        /// Rotations, in order.
        #[input(min = 1)]
        rotations: Vec<SuccessiveRotation>,
    },
}

/// One of several rotations after each other.
#[derive(Clone, Debug, Inputs)]
pub struct SuccessiveRotation {
    /// Rotation.
    pub rotation: SingleAttitude,
    /// Sense.
    /// The attitude of B relative to R from those of both in N: that of R inverted, then that of B.
    #[input(default = "forward")]
    pub sense: RotationSense,
}

/// Sense in which a rotation is taken: as given or back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum RotationSense {
    /// As given
    Forward,
    /// Inverted: the transpose
    Inverse,
}

/// Attitude of a frame B in a frame N, in one of its representations.
#[derive(Clone, Debug, Inputs)]
pub enum SingleAttitude {
    /// Euler angles
    /// Each rotation is about an axis of the frame that the one before it left.
    EulerAngles {
        /// Sequence.
        sequence: EulerSequence,
        /// First angle.
        #[input("α₁", "deg")]
        first: f64,
        /// Second angle.
        #[input("α₂", "deg")]
        second: f64,
        /// Third angle.
        #[input("α₃", "deg")]
        third: f64,
    },
    /// Direction cosine matrix
    /// It changes components in N into components in B. The transpose of a matrix that rotates vectors.
    DirectionCosines {
        /// First row: b₁ in components in N.
        #[input("C₁", "1")]
        first: Vector3<f64>,
        /// Second row: b₂ in components in N.
        #[input("C₂", "1")]
        second: Vector3<f64>,
        /// Third row: b₃ in components in N.
        #[input("C₃", "1")]
        third: Vector3<f64>,
    },
    /// Principal axis and angle
    PrincipalRotation {
        /// Principal axis, of any length.
        /// Its components in N and in B are the same.
        #[input("a", "1")]
        axis: Vector3<f64>,
        /// Principal angle.
        #[input("φ", "deg")]
        angle: f64,
    },
    /// Principal rotation vector
    /// Along the principal axis, as long as the angle in radians.
    RotationVector {
        /// Principal rotation vector.
        #[input("γ_g", "rad")]
        vector: Vector3<f64>,
    },
    /// Euler parameters: unit quaternion
    EulerParameters {
        /// Scalar part.
        /// β₀ = cos(Φ/2): the first number in some books, the last in others.
        #[input("β_s", "1")]
        scalar: f64,
        /// Vector part.
        /// (β₁; β₂; β₃) = e sin(Φ/2).
        #[input("β_v", "1")]
        vector: Vector3<f64>,
    },
    /// Rodrigues parameters: Gibbs vector
    /// Along the principal axis, as long as tan(Φ/2).
    Rodrigues {
        /// Rodrigues parameters.
        #[input("q_g", "1")]
        parameters: Vector3<f64>,
    },
    /// Modified Rodrigues parameters
    /// Along the principal axis, as long as tan(Φ/4).
    ModifiedRodrigues {
        /// Modified Rodrigues parameters.
        #[input("σ_g", "1")]
        parameters: Vector3<f64>,
    },
    /// Two directions seen in both frames: TRIAD
    Triad {
        /// First direction, in N.
        /// The more accurate one; of any length, as all four vectors.
        #[input("s_N", "1")]
        first_fixed: Vector3<f64>,
        /// First direction, in B.
        #[input("s_B", "1")]
        first_body: Vector3<f64>,
        /// Second direction, in N.
        #[input("m_N", "1")]
        second_fixed: Vector3<f64>,
        /// Second direction, in B.
        #[input("m_B", "1")]
        second_body: Vector3<f64>,
    },
    /// Weighted directions: q-method
    /// The attitude of the least sum of weighted squares of the errors of directions: Wahba's problem.
    Observations {
        /// Observed directions.
        #[input(min = 2)]
        observations: Vec<VectorObservation>,
    },
}

/// A matrix whose rows are off orthonormal by no more than this is taken as it is.
const EXACT: f64 = 1e-12;
/// By no more than this it was rounded to two decimals when it was printed, and is repaired.
const PRINTED: f64 = 0.02;
/// A set of Euler parameters may be off unit length by as much.
const PRINTED_LENGTH: f64 = 0.01;

/// The rows of `[BN]`.
///
/// # Errors
/// What is no attitude.
pub(crate) fn rows_of<W: Worksheet>(
    attitude: &AttitudeInput,
    given: &AttitudeInputGiven<W>,
    sheet: W,
) -> Result<[W::Vec; 3], Refusal> {
    match (attitude, given) {
        (AttitudeInput::One(one), AttitudeInputGiven::One(given)) => one.rows(given, None, sheet),
        (AttitudeInput::Successive { rotations }, AttitudeInputGiven::Successive { rotations: given }) => {
            successive(rotations, given, sheet)
        }
        _ => unreachable!("the inputs are lifted from the attitude"),
    }
}

/// Successive rotations: each matrix from the left.
fn successive<W: Worksheet>(
    rotations: &[SuccessiveRotation],
    given: &[SuccessiveRotationGiven<W>],
    sheet: W,
) -> Result<[W::Vec; 3], Refusal> {
    let mut whole: Option<[W::Vec; 3]> = None;
    let mut product = Matrix3::identity();
    let last = rotations.len();
    for (n, (rotation, this)) in rotations.iter().zip(given).enumerate() {
        let rows = rotation.rotation.rows(&this.rotation, Some(n + 1), sheet)?;
        let rows = match rotation.sense {
            RotationSense::Forward => rows,
            RotationSense::Inverse => {
                let elements = rows.map(Vector::components);
                let columns = [0, 1, 2].map(|k| {
                    let [x, y, z] = elements.map(|row| row[k]);
                    W::Vec::from_components(x, y, z)
                });
                const SYMBOLS: [&str; 3] = ["n′₁", "n′₂", "n′₃"];
                std::array::from_fn(|k| {
                    sheet.step_vector(
                        (SYMBOLS[k], n + 1),
                        "1",
                        columns[k],
                        ("The inverse is the transpose: a column becomes a row", SCHAUB.at("§3.2")),
                    )
                })
            }
        };
        product = matrix(rows) * product;
        whole = Some(match whole {
            None => rows,
            Some(before) => {
                let composed = rows.map(|row| row_times(row, before));
                let why = |_| {
                    Reason::from((
                        "Successive rotations: the matrix of the later one times that of the earlier ones",
                        SCHAUB.at("§3.2"),
                    ))
                };
                // The last ones are the rows of the whole.
                row_steps::<W>(composed, (n + 1 < last).then_some(last + n), why, sheet)
            }
        });
    }
    let whole = whole.expect("there is at least one rotation");
    sheet.verify(|| {
        sheet.check_zeros(
            "the product of the matrices of the rotations, less [BN]",
            (matrix(whole) - product).iter().copied(),
            1.0,
        );
    });
    Ok(whole)
}

impl SingleAttitude {
    /// The rows of its direction cosine matrix; `place` is its place among successive ones.
    fn rows<W: Worksheet>(
        &self,
        given: &SingleAttitudeGiven<W>,
        place: Option<usize>,
        sheet: W,
    ) -> Result<[W::Vec; 3], Refusal> {
        const ROWS: [&str; 3] = [
            "First row of the direction cosine matrix: b₁ in N",
            "Second row of the direction cosine matrix: b₂ in N",
            "Third row of the direction cosine matrix: b₃ in N",
        ];
        let symbol = |symbol: &'static str| dalembert_core::Symbol::from(symbol).row(place.unwrap_or(0));
        let steps = |elements: [[W::Num; 3]; 3], cite| {
            row_steps::<W>(rows(elements), place, |n| (ROWS[n], cite).into(), sheet)
        };
        let by_ep = |scalar: W::Num, vector: W::Vec| {
            steps(by_parameters(scalar, vector.components()), SCHAUB.at("§3.5"))
        };
        let result = match (self, given) {
            (
                &Self::EulerAngles { sequence, .. },
                SingleAttitudeGiven::EulerAngles { first, second, third, .. },
            ) => steps(sequence.elements([*first, *second, *third]), SCHAUB.at("§3.3")),
            (
                Self::DirectionCosines { first, second, third },
                SingleAttitudeGiven::DirectionCosines { first: a, second: b, third: c },
            ) => direction_cosines([*first, *second, *third], [*a, *b, *c], place, sheet)?,
            (
                Self::PrincipalRotation { axis, .. },
                SingleAttitudeGiven::PrincipalRotation { axis: a, angle },
            ) => {
                let along = if axis.norm_squared() == 1.0 {
                    *a
                } else {
                    check_length(
                        *axis,
                        "the principal axis has no length: write any vector along it, such as (0; 0; 1)",
                    )?;
                    let why = "Unit vector along the principal axis";
                    sheet.step_vector(symbol("â"), "1", *a / a.magnitude(), why)
                };
                steps(by_axis(along.components(), *angle), SCHAUB.at("§3.4"))
            }
            (Self::RotationVector { vector }, SingleAttitudeGiven::RotationVector { vector: v }) => {
                if *vector == Vector3::zeros() {
                    return Err(Refusal::because(
                        "a principal rotation vector of zero is no rotation and has no axis: give the attitude by an axis and an angle of 0°",
                    ));
                }
                let angle = sheet.step(
                    symbol("φ"),
                    "deg",
                    v.magnitude(),
                    "Principal angle: length of the principal rotation vector",
                );
                let along =
                    sheet.step_vector(symbol("â"), "1", *v / angle, "Unit vector along the principal axis");
                steps(by_axis(along.components(), angle), SCHAUB.at("§3.4"))
            }
            (
                Self::EulerParameters { scalar, vector },
                SingleAttitudeGiven::EulerParameters { scalar: s, vector: v },
            ) => {
                let off = (scalar.powi(2) + vector.norm_squared()).sqrt();
                if off.is_nan() || (off - 1.0).abs() > PRINTED_LENGTH {
                    return Err(Refusal::NoAnswer(
                        Text::new("the Euler parameters have the length {length}, and those of a rotation have 1: divide all four by their length, or check them")
                            .with_quantity("length", off, "1"),
                    ));
                }
                if (off - 1.0).abs() <= EXACT {
                    by_ep(*s, *v)
                } else {
                    let length = sheet.step(
                        symbol("|β|"),
                        "1",
                        (s.powi(2) + v.dot(*v)).sqrt(),
                        "Length of the Euler parameters as given, off 1 by rounding",
                    );
                    let scalar = sheet.step(symbol("β̂_s"), "1", *s / length, "Scalar part, normalised");
                    let vector =
                        sheet.step_vector(symbol("β̂_v"), "1", *v / length, "Vector part, normalised");
                    by_ep(scalar, vector)
                }
            }
            (Self::Rodrigues { .. }, SingleAttitudeGiven::Rodrigues { parameters }) => {
                let why = "Scalar Euler parameter from the Rodrigues parameters";
                let root = (parameters.dot(*parameters) + 1.0).sqrt();
                let scalar =
                    sheet.step(symbol("β̂_s"), "1", W::Num::from(1.0) / root, (why, SCHAUB.at("§3.6")));
                let vector =
                    sheet.step_vector(symbol("β̂_v"), "1", *parameters * scalar, "Vector part, from q = ε/β₀");
                by_ep(scalar, vector)
            }
            (Self::ModifiedRodrigues { .. }, SingleAttitudeGiven::ModifiedRodrigues { parameters }) => {
                let square = sheet.step(
                    symbol("σ_g²"),
                    "1",
                    parameters.dot(*parameters),
                    "Square of the modified Rodrigues parameters",
                );
                let why = "Scalar Euler parameter from the modified Rodrigues parameters";
                let scalar = sheet.step(
                    symbol("β̂_s"),
                    "1",
                    (-square + 1.0) / (square + 1.0),
                    (why, SCHAUB.at("§3.7")),
                );
                let vector = sheet.step_vector(
                    symbol("β̂_v"),
                    "1",
                    *parameters * (W::Num::from(2.0) / (square + 1.0)),
                    "Vector part, from σ = ε/(1 + β₀)",
                );
                by_ep(scalar, vector)
            }
            (
                Self::Triad { first_fixed, first_body, second_fixed, second_body },
                SingleAttitudeGiven::Triad {
                    first_fixed: s_n,
                    first_body: s_b,
                    second_fixed: m_n,
                    second_body: m_b,
                },
            ) => {
                let plain = [*first_fixed, *second_fixed, *first_body, *second_body];
                triad(plain, [*s_n, *m_n, *s_b, *m_b], place, sheet)?
            }
            (
                Self::Observations { observations },
                SingleAttitudeGiven::Observations { observations: given },
            ) => by_observations(observations, given, place, sheet)?,
            _ => unreachable!("the inputs are lifted from the attitude"),
        };
        let found = matrix(result);
        if !found.iter().all(|x| x.is_finite()) {
            return Err(Refusal::because("the attitude exceeds the numerical range: check its numbers"));
        }
        sheet.verify(|| self.check(&found, sheet));
        Ok(result)
    }

    /// Holds the matrix to the attitude by another way.
    fn check<W: Worksheet>(&self, c: &Matrix3<f64>, sheet: W) {
        let (off, scale) = match *self {
            Self::EulerAngles { sequence, first, second, third } => {
                (c - sequence.product([first, second, third]), 1.0)
            }
            Self::PrincipalRotation { axis, angle } => {
                (c - Rotation3::from_axis_angle(&Unit::new_normalize(axis), -angle).matrix(), 1.0)
            }
            Self::RotationVector { vector } => (c - Rotation3::from_scaled_axis(-vector).matrix(), 1.0),
            Self::EulerParameters { scalar, vector } => {
                let quaternion = nalgebra::Quaternion::from_parts(scalar, vector);
                (
                    c - UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().matrix().transpose(),
                    1.0,
                )
            }
            Self::Rodrigues { parameters } => {
                (off_cayley_formula(c, parameters, false), 1.0 + parameters.norm())
            }
            Self::ModifiedRodrigues { parameters } => {
                (off_cayley_formula(c, parameters, true), (1.0 + parameters.norm()).powi(2))
            }
            // These have checks of their own.
            Self::DirectionCosines { .. } | Self::Triad { .. } | Self::Observations { .. } => return,
        };
        sheet.check_zeros(
            "the direction cosine matrix by another formula of the attitude given",
            off.iter().copied(),
            scale,
        );
    }
}

/// The rows of a direction cosine matrix that is given, repaired where it was rounded.
fn direction_cosines<W: Worksheet>(
    plain: [Vector3<f64>; 3],
    given: [W::Vec; 3],
    place: Option<usize>,
    sheet: W,
) -> Result<[W::Vec; 3], Refusal> {
    let c = matrix(plain);
    let off = off_rotation(&c).amax();
    if off.is_nan() || off > PRINTED {
        return Err(Refusal::NoAnswer(
            Text::new("the rows of the direction cosine matrix are not orthonormal: [C][C]ᵀ is {off} off the unit matrix, more than rounding; check its elements")
                .with_quantity("off", off, "1"),
        ));
    }
    if c.determinant() < 0.0 {
        return Err(Refusal::because(
            "the determinant of the direction cosine matrix is −1, not +1: it mirrors a right-handed frame into a left-handed one and is no rotation; check the signs and the order of its rows",
        ));
    }
    if off <= EXACT {
        return Ok(given);
    }
    let nearest = nearest_rotation(&c)?;
    let rows = [0, 1, 2].map(|n| {
        const SYMBOLS: [&str; 3] = ["b₁", "b₂", "b₃"];
        let symbol = dalembert_core::Symbol::from(SYMBOLS[n]).row(place.unwrap_or(0));
        sheet.numerical_vector(
            symbol,
            "1",
            nearest.row(n).transpose(),
            "Row of the nearest rotation [C]([C]ᵀ[C])^(−1/2): the matrix as given is off orthonormal by rounding",
        )
    });
    sheet.verify(|| {
        let found = matrix(rows);
        let stretch = found.transpose() * c;
        let skew = stretch - stretch.transpose();
        sheet.check_zeros(
            "rows of the nearest rotation are orthonormal",
            off_rotation(&found).iter().copied(),
            1.0,
        );
        sheet.check_zeros("it leaves a symmetric stretch of the matrix given", skew.iter().copied(), 1.0);
    });
    sheet.warn(|| {
        Text::new("the direction cosine matrix is {off} off orthonormal, as rounding leaves it: the nearest rotation is used")
            .with_quantity("off", off, "1")
    });
    Ok(rows)
}

/// `C (CᵀC)^(−1/2)`
fn nearest_rotation(c: &Matrix3<f64>) -> Result<Matrix3<f64>, Refusal> {
    let square = c.transpose() * c;
    let eigen = linalg::symmetric_eigen(&DMatrix::from_fn(3, 3, |n, m| square[(n, m)]))
        .map_err(|error| Refusal::because(Text::new("{error}").with("error", error)))?;
    let mut root = Matrix3::zeros();
    for n in 0..3 {
        let axis = Vector3::from_fn(|k, _| eigen.vectors[(k, n)]);
        root += axis * axis.transpose() / eigen.values[n].sqrt();
    }
    Ok(c * root)
}

/// Directions at an angle whose sine is not above this are parallel.
const PARALLEL: f64 = 1e-9;
/// Angles between the directions in either frame that differ by more, rad, are worth a word.
const DIFFERENT: f64 = 0.01;

/// `[BN]` from two directions in both frames: first and second in N, first and second in B.
fn triad<W: Worksheet>(
    plain: [Vector3<f64>; 4],
    [first_n, second_n, first_b, second_b]: [W::Vec; 4],
    place: Option<usize>,
    sheet: W,
) -> Result<[W::Vec; 3], Refusal> {
    for vector in plain {
        check_length(vector, "one of the directions has no length: write any vector along it")?;
    }
    let units = plain.map(|vector| vector.normalize());
    if [[0, 1], [2, 3]].iter().any(|[a, b]| units[*a].cross(units[*b]).norm() <= PARALLEL) {
        return Err(Refusal::because(
            "the two directions are parallel and leave the rotation about them open: write two that are not",
        ));
    }
    let symbol = |symbol: &'static str| dalembert_core::Symbol::from(symbol).row(place.unwrap_or(0));
    let triad = |first: W::Vec, second: W::Vec, symbols: [&'static str; 3]| {
        let along = sheet.step_vector(
            symbol(symbols[0]),
            "1",
            first / first.magnitude(),
            "First vector of the triad: along the first direction",
        );
        let across = along.cross(second);
        let across = sheet.step_vector(
            symbol(symbols[1]),
            "1",
            across / across.magnitude(),
            "Second vector of the triad: normal to both directions",
        );
        let third =
            sheet.step_vector(symbol(symbols[2]), "1", along.cross(across), "Third vector of the triad");
        [along, across, third]
    };
    let fixed = triad(first_n, second_n, ["t₁", "t₂", "t₃"]);
    let body = triad(first_b, second_b, ["t₁ᴮ", "t₂ᴮ", "t₃ᴮ"]);
    let elements = body.map(Vector::components);
    let rows = [0, 1, 2].map(|n| {
        let column = elements.map(|t| t[n]);
        fixed[0] * column[0] + fixed[1] * column[1] + fixed[2] * column[2]
    });
    let why = |_| Reason::from("Row of [BN] = [BT][NT]ᵀ: the triad in components in B, times the triad in N");
    let rows = row_steps::<W>(rows, place, why, sheet);
    sheet.verify(|| {
        let c = matrix(rows);
        let normal = [[0, 1], [2, 3]].map(|[a, b]| units[a].cross(units[b]).normalize());
        let off = (c * units[0] - units[2]).norm().max((c * normal[0] - normal[1]).norm());
        sheet.check_zero(
            "[BN] brings the first direction and the normal to both into those in B",
            off.into(),
            1.0,
        );
    });
    let angles = [[0, 1], [2, 3]].map(|[a, b]| units[a].angle(&units[b]));
    let apart = (angles[0] - angles[1]).abs();
    if apart > DIFFERENT {
        sheet.warn(|| {
            Text::new("the angle between the two directions is {difference} larger or smaller in B than in N: the second direction is met in part only")
                .with_quantity("difference", apart, "deg")
        });
    }
    Ok(rows)
}
