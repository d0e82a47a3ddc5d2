//! A part of a body, written down step by step: its mass, its centre of mass, its inertia in the axes of the body.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid::primitive::Extent};
use nalgebra::{Matrix3, Vector3};

use super::{
    Amount, AmountGiven, BodyPart, BodyPartGiven, Presence, ReferencePoint, ShapeOrientation,
    ShapeOrientationGiven,
    common_errors::of_moment,
    shape::Described,
    working::{MOMENTS, Named, PAIRS, PRODUCTS, WorkedPart},
};
use crate::sources::MERIAM;

const OWN_MOMENTS: [&str; 3] = ["I_1", "I_2", "I_3"];
const OWN_PRODUCTS: [&str; 3] = ["I_23", "I_31", "I_12"];

impl BodyPart {
    /// Writes down a part; `row` is 0 for a part that is the whole body, whose symbols then carry no number.
    pub(super) fn work<W: Worksheet>(
        &self,
        given: &BodyPartGiven<W>,
        row: usize,
        sheet: W,
    ) -> Result<WorkedPart<W>, Refusal> {
        let shape = given.shape.described();
        let length = match shape {
            Described::Between(from, to) => Some(sheet.step(
                ("L", row),
                "m",
                (to - from).magnitude(),
                Named("Length of {name}", &self.name, None),
            )),
            _ => None,
        };
        let mass = self.mass(given, shape, length, row, sheet)?;
        let length = length.unwrap_or_else(|| 0.0.into());
        let rotation = *self.rotation()?.matrix();
        let turned = !shape.is_ball() && rotation != Matrix3::identity();
        let axes = if turned { self.axes(given, shape, rotation, row, sheet) } else { None };

        let arm = shape.to_centre(self.reference.anchor(), length).ok_or_else(|| self.without_point())?;
        let arm = match shape {
            Described::Between(from, to) if self.reference == ReferencePoint::Origin => {
                Some((from + to) / 2.0.into())
            }
            _ if arm.value() == Vector3::zeros() => None,
            _ if rotation == Matrix3::identity() => Some(arm),
            _ => {
                let arm = sheet.step_vector(
                    ("s", row),
                    "m",
                    arm,
                    Named(
                        "From the reference point of {name} to its centre of mass, in its own axes",
                        &self.name,
                        Some(MERIAM.at("table D/4")),
                    ),
                );
                Some(along(axes, rotation, arm))
            }
        };
        let centre = match arm {
            Some(arm) => given.position + arm,
            None => given.position,
        };
        let centre = if arm.is_some() || row == 0 {
            sheet.step_vector(
                ("r_G", row),
                "m",
                centre,
                Named("Centre of mass of {name}", &self.name, Some(MERIAM.at("table D/4"))),
            )
        } else {
            centre
        };
        let (moments, products) = self.inertia([mass, length], shape, axes, rotation, row, sheet);
        let named = axes.is_some() || (!turned && !shape.is_round());
        Ok(WorkedPart { mass, centre, moments, products, named })
    }

    fn mass<W: Worksheet>(
        &self,
        given: &BodyPartGiven<W>,
        shape: Described<W::Vec>,
        length: Option<W::Num>,
        row: usize,
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        let hole = self.presence == Presence::Hole;
        let named = |reason: &'static str| Named(reason, &self.name, None);
        let extent = shape.extent(|from, to| length.unwrap_or_else(|| (to - from).magnitude()));
        let (density, extent) = match (&self.amount, &given.amount, extent) {
            (Amount::Mass { .. }, AmountGiven::Mass { mass }, _) => {
                return Ok(match (hole, row) {
                    (true, _) => sheet.step(("m_h", row), "kg", -*mass, named("Mass of {name}, subtracted")),
                    (false, 0) => sheet.step("m", "kg", *mass, named("Mass of {name}")),
                    (false, _) => *mass,
                });
            }
            (Amount::PerLength { .. }, AmountGiven::PerLength { density }, Extent::Length(extent)) => {
                let plain = matches!(&self.shape, super::Shape::Rod { .. }) || length.is_some();
                let extent = if plain {
                    extent
                } else {
                    sheet.step(("s", row), "m", extent, named("Length of {name}"))
                };
                (*density, extent)
            }
            (Amount::PerArea { .. }, AmountGiven::PerArea { density }, Extent::Area(extent)) => {
                (*density, sheet.step(("A", row), "m^2", extent, named("Area of {name}")))
            }
            (Amount::PerVolume { .. }, AmountGiven::PerVolume { density }, Extent::Volume(extent)) => {
                (*density, sheet.step(("V", row), "m^3", extent, named("Volume of {name}")))
            }
            _ => return Err(self.wrong_measure()),
        };
        Ok(if hole {
            sheet.step(("m", row), "kg", -(density * extent), named("Mass of {name}, subtracted"))
        } else {
            sheet.step(("m", row), "kg", density * extent, named("Mass of {name}"))
        })
    }

    /// The own axes in the frame of the body: of a shape of revolution the third one only. `None` where they lie
    /// along x, y and z in some order.
    fn axes<W: Worksheet>(
        &self,
        given: &BodyPartGiven<W>,
        shape: Described<W::Vec>,
        rotation: Matrix3<f64>,
        row: usize,
        sheet: W,
    ) -> Option<[W::Vec; 3]> {
        let column = |n: usize| -> Vector3<f64> { rotation.column(n).into() };
        let lies_along = |axis: Vector3<f64>| axis.iter().filter(|x| **x != 0.0).count() == 1;
        let named = |reason: &'static str| Named(reason, &self.name, None);
        if shape.is_round() {
            if lies_along(column(2)) {
                return None;
            }
            let reason = named("Direction of the axis of {name}");
            let axis = match (&self.direction, &given.direction, shape) {
                (_, _, Described::Between(from, to)) => {
                    sheet.step_vector(("λ", row), "1", (to - from) / (to - from).magnitude(), reason)
                }
                (ShapeOrientation::Axis { .. }, ShapeOrientationGiven::Axis { axis }, _) => {
                    sheet.step_vector(("λ", row), "1", *axis / axis.magnitude(), reason)
                }
                _ => sheet.numerical_vector(("λ", row), "1", column(2), reason),
            };
            return Some([axis; 3]);
        }
        if (0..3).all(|n| lies_along(column(n))) {
            return None;
        }
        let axis = |n: usize, symbol: &'static str, reason: &'static str| {
            sheet.numerical_vector((symbol, row), "1", column(n), named(reason))
        };
        Some([
            axis(0, "i_b", "Direction of the x axis of {name}"),
            axis(1, "j_b", "Direction of the y axis of {name}"),
            axis(2, "k_b", "Direction of the z axis of {name}"),
        ])
    }

    /// Moments and products about the axes of the body through the centre of mass of the part.
    fn inertia<W: Worksheet>(
        &self,
        [mass, length]: [W::Num; 2],
        shape: Described<W::Vec>,
        axes: Option<[W::Vec; 3]>,
        rotation: Matrix3<f64>,
        row: usize,
        sheet: W,
    ) -> ([Option<W::Num>; 3], [Option<W::Num>; 3]) {
        let why =
            |reason: &'static str, place: &'static str| Named(reason, &self.name, Some(MERIAM.at(place)));
        let table = |symbol: &'static str, value: W::Num, reason: &'static str| {
            (value.value() != 0.0)
                .then(|| sheet.step((symbol, row), "kg*m^2", value, why(reason, "table D/4")))
        };
        let own = shape.inertia(mass, length);
        let about = |symbol: &'static str, axis: usize, reason: &'static str| {
            of_moment(shape, axis, (symbol, row), [mass, length], sheet);
            table(symbol, own.moments[axis], reason)
        };
        if shape.is_ball() {
            let any =
                about("I_G", 0, "Moment of inertia of {name} about any axis through its centre of mass");
            return ([any; 3], [None; 3]);
        }
        if shape.is_round() {
            let across = about("I_t", 0, "Transverse moment of inertia of {name}, about its centre of mass");
            let along = about("I_a", 2, "Moment of inertia of {name} about its own axis");
            let Some([_, _, axis]) = axes else {
                // The axis lies along one of the axes of the body.
                let moment = |n: usize| if rotation[(n, 2)] == 0.0 { across } else { along };
                return ([moment(0), moment(1), moment(2)], [None; 3]);
            };
            let cosines = axis.components();
            let moment = |n: usize| -> Option<W::Num> {
                let square = cosines[n].powi(2);
                let value = match (across, along) {
                    (Some(across), Some(along)) => across + (along - across) * square,
                    (Some(across), None) => across * (W::Num::from(1.0) - square),
                    (None, Some(along)) => along * square,
                    (None, None) => return None,
                };
                Some(sheet.step(
                    (MOMENTS[n], row),
                    "kg*m^2",
                    value,
                    why("Moment of inertia of {name} about an axis of the body through its centre of mass, from its direction cosines", "App. B/2"),
                ))
            };
            let moments = [moment(0), moment(1), moment(2)];
            let product = |n: usize| -> Option<W::Num> {
                let (a, b) = PAIRS[n];
                if cosines[a].value() == 0.0 || cosines[b].value() == 0.0 {
                    return None;
                }
                let value = match (across, along) {
                    (Some(across), Some(along)) => (across - along) * cosines[a] * cosines[b],
                    (Some(across), None) => across * cosines[a] * cosines[b],
                    (None, Some(along)) => -(along * cosines[a] * cosines[b]),
                    (None, None) => return None,
                };
                Some(sheet.step(
                    (PRODUCTS[n], row),
                    "kg*m^2",
                    value,
                    why("Product of inertia of {name}, in the same way", "App. B/2"),
                ))
            };
            return (moments, [product(0), product(1), product(2)]);
        }
        let names =
            if rotation == Matrix3::identity() { (MOMENTS, PRODUCTS) } else { (OWN_MOMENTS, OWN_PRODUCTS) };
        let reason = "Moment of inertia of {name} about one of its own axes through its centre of mass";
        let moments =
            [about(names.0[0], 0, reason), about(names.0[1], 1, reason), about(names.0[2], 2, reason)];
        let products = own.products.map_or([None; 3], |[yz, zx, xy]| {
            let reason = "Product of inertia of {name} in its own axes through its centre of mass";
            [table(names.1[0], yz, reason), table(names.1[1], zx, reason), table(names.1[2], xy, reason)]
        });
        let Some(axes) = axes else {
            return permuted(moments, products, rotation);
        };
        let cosines = axes.map(Vector::components);
        let moment = |n: usize| -> Option<W::Num> {
            let squares = (0..3).filter_map(|k| Some(moments[k]? * cosines[k][n].powi(2)));
            let crossed = PAIRS
                .into_iter()
                .zip(products)
                .filter_map(|((a, b), product)| Some(-(product? * cosines[a][n] * cosines[b][n] * 2.0)));
            let terms: Vec<W::Num> = squares.chain(crossed).collect();
            (!terms.is_empty()).then(|| {
                sheet.step(
                    (MOMENTS[n], row),
                    "kg*m^2",
                    <W::Num as Real>::sum(terms),
                    why("Moment of inertia of {name} about an axis of the body through its centre of mass, from its direction cosines", "App. B/2"),
                )
            })
        };
        let turned = [moment(0), moment(1), moment(2)];
        let product = |n: usize| -> Option<W::Num> {
            let (i, j) = PAIRS[n];
            let squares = (0..3).filter_map(|k| Some(-(moments[k]? * cosines[k][i] * cosines[k][j])));
            let crossed = PAIRS.into_iter().zip(products).filter_map(|((a, b), product)| {
                Some(product? * (cosines[a][i] * cosines[b][j] + cosines[b][i] * cosines[a][j]))
            });
            let terms: Vec<W::Num> = squares.chain(crossed).collect();
            (!terms.is_empty()).then(|| {
                sheet.step(
                    (PRODUCTS[n], row),
                    "kg*m^2",
                    <W::Num as Real>::sum(terms),
                    why("Product of inertia of {name}, in the same way", "App. B/2"),
                )
            })
        };
        (turned, [product(0), product(1), product(2)])
    }
}

/// A vector given in own axes, in the axes of the body.
fn along<V: Vector>(axes: Option<[V; 3]>, rotation: Matrix3<f64>, own: V) -> V {
    let own = own.components();
    match axes {
        // Of a shape of revolution the third axis alone counts: its centre of mass and its ends lie on it.
        Some(axes) => (0..3)
            .filter(|&n| own[n].value() != 0.0)
            .map(|n| axes[n] * own[n])
            .reduce(|sum, term| sum + term)
            .unwrap_or(axes[2] * own[2]),
        None => {
            let along = |n: usize| {
                let from = (0..3).find(|&k| rotation[(n, k)] != 0.0).unwrap_or(n);
                if rotation[(n, from)] < 0.0 && own[from].value() != 0.0 { -own[from] } else { own[from] }
            };
            V::from_components(along(0), along(1), along(2))
        }
    }
}

/// Moments and products in axes that are the own ones in another order or sense.
fn permuted<S: Real>(
    moments: [Option<S>; 3],
    products: [Option<S>; 3],
    rotation: Matrix3<f64>,
) -> ([Option<S>; 3], [Option<S>; 3]) {
    let from = |n: usize| (0..3).find(|&k| rotation[(n, k)] != 0.0).unwrap_or(n);
    let product = |n: usize| {
        let (i, j) = PAIRS[n];
        let (a, b) = (from(i), from(j));
        // The pair of axes other than k stands at the place k.
        let product = products[3 - a - b]?;
        Some(if rotation[(i, a)] * rotation[(j, b)] < 0.0 { -product } else { product })
    };
    ([moments[from(0)], moments[from(1)], moments[from(2)]], [product(0), product(1), product(2)])
}
