//! Euler angles of the twelve sequences of body axes.

use dalembert_core::{Inputs, Worksheet};
use dalembert_mechanics::{Real, Vector};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use crate::sources::SCHAUB;

/// Sequence of three rotations, each about an axis of the frame that the one before it left.
///
/// About fixed axes the same rotations take place in the opposite order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum EulerSequence {
    /// 3-2-1: yaw, pitch, roll
    Zyx,
    /// 3-1-3: precession, nutation, spin
    Zxz,
    /// 1-2-3
    Xyz,
    /// 1-3-2
    Xzy,
    /// 2-1-3
    Yxz,
    /// 2-3-1
    Yzx,
    /// 3-1-2
    Zxy,
    /// 1-2-1
    Xyx,
    /// 1-3-1
    Xzx,
    /// 2-1-2
    Yxy,
    /// 2-3-2
    Yzy,
    /// 3-2-3
    Zyz,
}

/// Below this the middle rotation brings the first axis into line with the third.
const LOCK: f64 = 1e-9;

/// Unit vector along an axis, 0 for x.
pub(crate) fn unit(axis: usize) -> Vector3<f64> {
    let mut unit = Vector3::zeros();
    unit[axis] = 1.0;
    unit
}

impl EulerSequence {
    /// The axes of the three rotations, 0 for x.
    pub(crate) fn axes(self) -> [usize; 3] {
        match self {
            Self::Zyx => [2, 1, 0],
            Self::Zxz => [2, 0, 2],
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Xyx => [0, 1, 0],
            Self::Xzx => [0, 2, 0],
            Self::Yxy => [1, 0, 1],
            Self::Yzy => [1, 2, 1],
            Self::Zyz => [2, 1, 2],
        }
    }

    /// `3-2-1`
    pub(crate) fn name(self) -> String {
        let [first, second, third] = self.axes().map(|axis| axis + 1);
        format!("{first}-{second}-{third}")
    }

    /// The axes `i`, `j` and the one normal to both, with 1 if they follow one another cyclically and −1 otherwise.
    fn order(self) -> ([usize; 3], f64) {
        let [i, j, _] = self.axes();
        ([i, j, 3 - i - j], if (i + 1) % 3 == j { 1.0 } else { -1.0 })
    }

    /// Returns true if the first rotation and the third are about the same axis.
    pub(crate) fn repeats(self) -> bool {
        let [first, _, third] = self.axes();
        first == third
    }

    /// The elements of `[BN]`.
    pub(crate) fn elements<N: Real>(self, angles: [N; 3]) -> [[N; 3]; 3] {
        let ([i, j, k], sign) = self.order();
        let ([s1, s2, s3], [c1, c2, c3]) = (angles.map(Real::sin), angles.map(Real::cos));
        let signed = |x: N| if sign < 0.0 { -x } else { x };
        let mut c = [[N::from(0.0); 3]; 3];
        if self.repeats() {
            c[i][i] = c2;
            c[i][j] = s1 * s2;
            c[i][k] = signed(-(c1 * s2));
            c[j][i] = s2 * s3;
            c[j][j] = c1 * c3 - s1 * c2 * s3;
            c[j][k] = signed(s1 * c3 + c1 * c2 * s3);
            c[k][i] = signed(s2 * c3);
            c[k][j] = signed(-(c1 * s3) - s1 * c2 * c3);
            c[k][k] = c1 * c2 * c3 - s1 * s3;
        } else {
            c[i][i] = c2 * c3;
            c[i][j] = s1 * s2 * c3 + signed(c1 * s3);
            c[i][k] = s1 * s3 - signed(c1 * s2 * c3);
            c[j][i] = signed(-(c2 * s3));
            c[j][j] = c1 * c3 - signed(s1 * s2 * s3);
            c[j][k] = c1 * s2 * s3 + signed(s1 * c3);
            c[k][i] = signed(s2);
            c[k][j] = signed(-(s1 * c2));
            c[k][k] = c1 * c2;
        }
        c
    }

    /// `[BN]` as a product of rotations about axes.
    pub(crate) fn product(self, angles: [f64; 3]) -> Matrix3<f64> {
        let [first, second, third] = std::array::from_fn(|n| {
            Rotation3::from_axis_angle(&Unit::new_unchecked(unit(self.axes()[n])), angles[n])
        });
        (first * second * third).matrix().transpose()
    }

    /// The axes of the three rotations in components in B: ω is the sum of each times its rate.
    pub(crate) fn axes_in_body<V: Vector>(self, angles: [V::Scalar; 3]) -> [V; 3] {
        let vector = |[x, y, z]: [V::Scalar; 3]| V::from_components(x, y, z);
        let [zero, one] = [0.0, 1.0].map(V::Scalar::from);
        let elements = self.elements(angles);
        let [first, second, third] = self.axes();
        // Turned by the third rotation alone.
        let mut middle = [zero; 3];
        middle[second] = angles[2].cos();
        let other = 3 - second - third;
        let sine = angles[2].sin();
        middle[other] = if (third + 1) % 3 == second { -sine } else { sine };
        let mut last = [zero; 3];
        last[third] = one;
        [vector(elements.map(|row| row[first])), vector(middle), vector(last)]
    }
}

/// The Euler angles of an attitude.
#[derive(Clone, Copy)]
pub(crate) struct ReportedAngles<N> {
    /// First, second and third angle, rad.
    pub angles: [N; 3],
    /// True at gimbal lock, where the third angle was set to zero.
    pub gimbal_lock: bool,
}

/// Euler angles of `[BN]` as plain numbers.
pub(crate) fn plain_angles(sequence: EulerSequence, c: &Matrix3<f64>) -> ReportedAngles<f64> {
    let rows = [0, 1, 2].map(|n| c.row(n).transpose());
    let (gimbal_lock, angles) = from_elements(sequence, rows.map(|row| [row.x, row.y, row.z]));
    ReportedAngles { angles, gimbal_lock }
}

/// The angles, with true first at gimbal lock.
pub(super) fn from_elements<N: Real>(sequence: EulerSequence, c: [[N; 3]; 3]) -> (bool, [N; 3]) {
    let ([i, j, k], sign) = sequence.order();
    let signed = |x: N| if sign < 0.0 { -x } else { x };
    let size = |a: N, b: N| (a.powi(2) + b.powi(2)).sqrt();
    let repeats = sequence.repeats();
    let across = if repeats { size(c[i][j], c[i][k]) } else { size(c[i][i], c[j][i]) };
    let second = if repeats { across.atan2(c[i][i]) } else { signed(c[k][i]).atan2(across) };
    if across.value() <= LOCK {
        return (true, [signed(c[j][k]).atan2(c[j][j]), second, N::from(0.0)]);
    }
    let first = if repeats { c[i][j].atan2(signed(-c[i][k])) } else { signed(-c[k][j]).atan2(c[k][k]) };
    let third = if repeats { c[j][i].atan2(signed(c[k][i])) } else { signed(-c[j][i]).atan2(c[i][i]) };
    (false, [first, second, third])
}

/// The Euler angles of `[BN]`, as steps.
pub(crate) fn angles_of<W: Worksheet>(
    sequence: EulerSequence,
    rows: [W::Vec; 3],
    sheet: W,
) -> ReportedAngles<W::Num> {
    let elements = rows.map(Vector::components);
    let (gimbal_lock, [first, second, third]) = from_elements(sequence, elements);
    if !gimbal_lock {
        let transposed = [0, 1, 2].map(|n| elements.map(|row| row[n]));
        for (n, symbol) in ["θ₁", "θ₂", "θ₃"].into_iter().enumerate() {
            // The middle angle of a sequence that repeats its axis is the same.
            if n != 1 || !sequence.repeats() {
                sheet.common_error(symbol, "the transposed matrix, [NB], used", || {
                    from_elements(sequence, transposed).1[n]
                });
            }
        }
    }
    let second_why = if sequence.repeats() {
        "Second Euler angle, from 0° to 180°, from the element of [BN] that is its cosine"
    } else {
        "Second Euler angle, from −90° to 90°, from the element of [BN] that is its sine"
    };
    let second = sheet.step("θ₂", "deg", second, (second_why, SCHAUB.at("§3.3")));
    let first_why = if gimbal_lock {
        "Gimbal lock: only the sum or difference of the first and third angles is determined; the third is set to zero"
    } else {
        "First Euler angle, from the ratio of two elements of [BN]"
    };
    let first = sheet.step("θ₁", "deg", first, (first_why, SCHAUB.at("§3.3")));
    let third = if gimbal_lock {
        sheet.numerical("θ₃", "deg", 0.0, "Third Euler angle, set to zero at gimbal lock")
    } else {
        sheet.step("θ₃", "deg", third, "Third Euler angle, from the ratio of two elements of [BN]")
    };
    ReportedAngles { angles: [first, second, third], gimbal_lock }
}
