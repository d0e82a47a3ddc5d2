//! Mass, mass centre and inertia of a body, written down step by step.

use dalembert_core::{Cite, Refusal, Text, Why, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{
        MassProperties,
        primitive::{Extent, OwnInertia},
    },
};
use nalgebra::{Matrix3, Vector3};

use super::{
    Amount, AmountGiven, Body, BodyGiven, Direction, DirectionGiven, Part, PartGiven, Presence,
    ReferencePoint, TakenAbout, TakenAboutGiven, shape::Described,
};
use crate::sources::MERIAM;

/// A body on a worksheet.
pub(crate) struct Worked<W: Worksheet> {
    /// Mass.
    pub(crate) mass: W::Num,
    /// Position of the mass centre.
    pub(crate) centre: W::Vec,
    /// Moments of inertia about the axes through G: Iₓ, I_y, I_z.
    pub(crate) moments: [W::Num; 3],
    /// Products of inertia I_yz, I_zx, I_xy, `I_xy = ∫ xy dm`.
    pub(crate) products: [W::Num; 3],
    /// The same by tensors alone.
    pub(crate) properties: MassProperties,
}

/// A part on a worksheet; what is exactly zero is left out.
struct Piece<W: Worksheet> {
    mass: W::Num,
    centre: W::Vec,
    moments: [Option<W::Num>; 3],
    products: [Option<W::Num>; 3],
    /// Whether these carry the symbols of the axes of the body.
    named: bool,
}

/// A reason that names a part; written only where somebody reads it.
pub(super) struct Named<'a>(&'static str, &'a str, Option<Cite>);

impl From<Named<'_>> for Why {
    fn from(Named(reason, name, cite): Named<'_>) -> Self {
        Why { reason: Text::new(reason).with("name", name), cite }
    }
}

/// The pairs of axes that the products of inertia stand for: yz, zx, xy.
pub(crate) const PAIRS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];
const MOMENTS: [&str; 3] = ["I_x", "I_y", "I_z"];
const PRODUCTS: [&str; 3] = ["I_yz", "I_zx", "I_xy"];
const OWN_MOMENTS: [&str; 3] = ["I_1", "I_2", "I_3"];
const OWN_PRODUCTS: [&str; 3] = ["I_23", "I_31", "I_12"];

impl<W: Worksheet> Worked<W> {
    /// Angular momentum about the mass centre of the body turning at `ω`, or a row of the inertia matrix for each
    /// of its components: `H_x = I_x ω_x − I_xy ω_y − I_zx ω_z`.
    pub(crate) fn momentum(&self, omega: W::Vec) -> W::Vec {
        matrix_times(self.moments, self.products, omega)
    }
}

/// The inertia matrix with these moments and products, times a vector. Products that are zero are left out.
pub(crate) fn matrix_times<V: Vector>(moments: [V::Scalar; 3], products: [V::Scalar; 3], vector: V) -> V {
    let [x, y, z] = vector.components();
    let [yz, zx, xy] = products;
    let less = |whole: V::Scalar, product: V::Scalar, component: V::Scalar| {
        if product.value() == 0.0 { whole } else { whole - product * component }
    };
    V::from_components(
        less(less(moments[0] * x, xy, y), zx, z),
        less(less(moments[1] * y, yz, z), xy, x),
        less(less(moments[2] * z, zx, x), yz, y),
    )
}

/// The moment of inertia about a line with direction cosines `λ`.
pub(crate) fn about_line<V: Vector>(
    moments: [V::Scalar; 3],
    products: [V::Scalar; 3],
    along: V,
) -> V::Scalar {
    let along = along.components();
    let squares = (0..3)
        .filter(|&n| along[n].value() != 0.0)
        .map(|n| moments[n] * along[n].powi(2))
        .reduce(|sum, term| sum + term)
        .unwrap_or_else(|| V::Scalar::from(0.0));
    PAIRS.into_iter().zip(products).fold(squares, |sum, ((a, b), product)| {
        if product.value() == 0.0 || along[a].value() == 0.0 || along[b].value() == 0.0 {
            sum
        } else {
            sum - product * along[a] * along[b] * 2.0
        }
    })
}

impl Body {
    /// Writes down the mass, the mass centre and the inertia about it.
    ///
    /// # Errors
    /// A refusal that names the part.
    pub(crate) fn work<W: Worksheet>(&self, given: &BodyGiven<W>, sheet: W) -> Result<Worked<W>, Refusal> {
        let properties = self.properties()?;
        let (mass, centre, moments, products) = match (self, given) {
            (Body::Parts { parts }, BodyGiven::Parts { parts: given }) => composed(parts, given, sheet)?,
            (
                Body::Matrix { about, .. },
                BodyGiven::Matrix { mass, centre, moments, products, about: given_about },
            ) => {
                let arm = match (about, given_about) {
                    (TakenAbout::Point { .. }, TakenAboutGiven::Point { point }) => {
                        let arm = sheet.step_vector("d", "m", *centre - *point, "From the given point to G");
                        (arm.value() != Vector3::zeros()).then_some(arm)
                    }
                    _ => None,
                };
                let (from, known) = (moments.components(), products.components());
                let reason = match arm {
                    Some(_) => {
                        "Parallel axes, back to G: less m times the square of the distance of the axes"
                    }
                    None => "Moment of inertia as given, about an axis through G",
                };
                let moment = |n: usize| {
                    let value = match arm.and_then(|arm| transferred(*mass, arm, n)) {
                        Some(shift) => from[n] - shift,
                        None => from[n],
                    };
                    sheet.step(MOMENTS[n], "kg*m^2", value, (reason, MERIAM.at("App. B/1")))
                };
                let moments = [moment(0), moment(1), moment(2)];
                let product = |n: usize| match arm.and_then(|arm| crossed(*mass, arm, n)) {
                    Some(shift) => sheet.step(
                        PRODUCTS[n],
                        "kg*m^2",
                        known[n] - shift,
                        ("Product of inertia, back to G in the same way", MERIAM.at("App. B/2")),
                    ),
                    None => sheet.step(
                        PRODUCTS[n],
                        "kg*m^2",
                        known[n],
                        ("Product of inertia as given", MERIAM.at("App. B/2")),
                    ),
                };
                (*mass, *centre, moments, [product(0), product(1), product(2)])
            }
            (Body::Radii { .. }, BodyGiven::Radii { mass, centre, radii }) => {
                let radii = radii.components();
                let moment = |n: usize| {
                    sheet.step(
                        MOMENTS[n],
                        "kg*m^2",
                        *mass * radii[n].powi(2),
                        ("Moment of inertia from its radius of gyration", MERIAM.at("App. B/1")),
                    )
                };
                let moments = [moment(0), moment(1), moment(2)];
                let none = |n: usize| sheet.found(PRODUCTS[n], "kg*m^2", 0.0, NO_PRODUCT);
                (*mass, *centre, moments, [none(0), none(1), none(2)])
            }
            _ => return Err(Refusal::because("the body is not described")),
        };
        let mass = match self {
            Body::Parts { .. } => mass,
            _ => sheet.step("m", "kg", mass, "Mass of this body"),
        };
        let centre = match self {
            Body::Parts { .. } => centre,
            _ => sheet.step_vector("r_G", "m", centre, "Position of the mass centre G"),
        };
        let worked = Worked { mass, centre, moments, products, properties };
        sheet.verify(|| worked.check(sheet));
        Ok(worked)
    }
}

const NO_PRODUCT: &str = "No product of inertia: the axes through G are principal";

impl<W: Worksheet> Worked<W> {
    /// Against sums of tensors.
    fn check(&self, sheet: W) {
        let tensor = self.properties.inertia;
        let size = tensor.amax();
        let off = (0..3).map(|n| {
            let (a, b) = PAIRS[n];
            let moment = self.moments[n].value() - tensor[(n, n)];
            let product = self.products[n].value() + tensor[(a, b)];
            moment.abs().max(product.abs())
        });
        sheet.check_zero(
            "the inertia matrix from the sum of the turned and shifted tensors R I Rᵀ + m (d² 1 − d dᵀ)",
            off.fold(0.0, f64::max).into(),
            size,
        );
        sheet.check_zero(
            "the mass centre from the tensors",
            (self.centre.value() - self.properties.centre).norm().into(),
            self.properties.centre.norm().max((size / self.properties.mass).sqrt()),
        );
        sheet.check("the mass of the parts together", self.mass, self.properties.mass.into());
    }
}

type Whole<W> =
    (<W as Worksheet>::Num, <W as Worksheet>::Vec, [<W as Worksheet>::Num; 3], [<W as Worksheet>::Num; 3]);

/// The body of the parts: one alone, or the sum of all by the theorem of parallel axes.
fn composed<W: Worksheet>(parts: &[Part], given: &[PartGiven<W>], sheet: W) -> Result<Whole<W>, Refusal> {
    let sole = parts.len() == 1;
    let mut pieces = Vec::with_capacity(parts.len());
    for (row, (part, given)) in (1..).zip(parts.iter().zip(given)) {
        pieces.push(part.work(given, if sole { 0 } else { row }, sheet)?);
    }
    let zero = |symbol: &'static str, why: &'static str| sheet.found(symbol, "kg*m^2", 0.0, why);
    if let [piece] = &pieces[..] {
        let named = |symbol: &'static str, value: W::Num, reason: &'static str| {
            if piece.named { value } else { sheet.step(symbol, "kg*m^2", value, reason) }
        };
        let moment = |n: usize| match piece.moments[n] {
            Some(moment) => {
                named(MOMENTS[n], moment, "Moment of inertia about an axis of the body through G")
            }
            None => zero(
                MOMENTS[n],
                "A line has no moment of inertia about itself, nor a particle about its place",
            ),
        };
        let product = |n: usize| match piece.products[n] {
            Some(product) => {
                named(PRODUCTS[n], product, "Product of inertia in the axes of the body through G")
            }
            None => zero(PRODUCTS[n], NO_PRODUCT),
        };
        let moments = [moment(0), moment(1), moment(2)];
        return Ok((piece.mass, piece.centre, moments, [product(0), product(1), product(2)]));
    }
    let mass = sheet.step("m", "kg", Real::sum(pieces.iter().map(|piece| piece.mass)), "Mass of all parts");
    let centre = sheet.step_vector(
        "r_G",
        "m",
        <W::Vec as Vector>::sum(pieces.iter().map(|piece| piece.centre * piece.mass)) / mass,
        ("Mass centre G: the mean of the mass centres, weighted with the masses", MERIAM.at("§4/2")),
    );
    let arms: Vec<W::Vec> = pieces
        .iter()
        .zip(1..)
        .zip(parts)
        .map(|((piece, row), part)| {
            sheet.step_vector(
                ("d", row),
                "m",
                piece.centre - centre,
                Named("From G to the mass centre of {name}", &part.name, None),
            )
        })
        .collect();
    let together = |own: &dyn Fn(&Piece<W>) -> Option<W::Num>,
                    shift: &dyn Fn(&Piece<W>, W::Vec) -> Option<W::Num>| {
        let terms: Vec<W::Num> = pieces
            .iter()
            .zip(&arms)
            .filter_map(|(piece, arm)| match (own(piece), shift(piece, *arm)) {
                (Some(own), Some(shift)) => Some(own + shift),
                (own, shift) => own.or(shift),
            })
            .collect();
        (!terms.is_empty()).then(|| <W::Num as Real>::sum(terms))
    };
    let moment = |n: usize| {
        let sum = together(&|piece| piece.moments[n], &|piece, arm| transferred(piece.mass, arm, n));
        match sum {
            Some(sum) => sheet.step(
                MOMENTS[n],
                "kg*m^2",
                sum,
                (
                    "Moment of inertia about an axis through G: those of the parts, moved by parallel axes",
                    MERIAM.at("App. B/1"),
                ),
            ),
            None => zero(MOMENTS[n], "All parts lie on the axis"),
        }
    };
    let product = |n: usize| {
        let sum = together(&|piece| piece.products[n], &|piece, arm| crossed(piece.mass, arm, n));
        match sum {
            Some(sum) => sheet.step(
                PRODUCTS[n],
                "kg*m^2",
                sum,
                ("Product of inertia about G, I_xy = ∫ xy dm; in the inertia matrix it stands with a minus sign", MERIAM.at("App. B/2")),
            ),
            None => zero(PRODUCTS[n], NO_PRODUCT),
        }
    };
    let moments = [moment(0), moment(1), moment(2)];
    Ok((mass, centre, moments, [product(0), product(1), product(2)]))
}

/// What a moment of inertia gains by a mass at an arm from the axis: `m (d_y² + d_z²)`, and cyclically. Nothing is
/// written for a component that is zero.
pub(crate) fn transferred<V: Vector>(mass: V::Scalar, arm: V, axis: usize) -> Option<V::Scalar> {
    let (a, b) = PAIRS[axis];
    let squares = [a, b].map(|n| arm.components()[n]).into_iter().filter(|part| part.value() != 0.0);
    let sum = squares.map(|part| part.powi(2)).reduce(|sum, square| sum + square)?;
    Some(mass * sum)
}

/// What a product of inertia gains by a mass at an arm: `m d_x d_y`, and cyclically.
pub(crate) fn crossed<V: Vector>(mass: V::Scalar, arm: V, pair: usize) -> Option<V::Scalar> {
    let (a, b) = PAIRS[pair];
    let arm = arm.components();
    (arm[a].value() != 0.0 && arm[b].value() != 0.0).then(|| mass * arm[a] * arm[b])
}

/// A moment or product of inertia and what it gains.
pub(crate) fn gained<S: Real>(own: S, gain: Option<S>) -> S {
    match gain {
        Some(gain) if own.value() == 0.0 => gain,
        Some(gain) => own + gain,
        None => own,
    }
}

impl Part {
    /// Writes down a part; `row` is 0 for a part that is the whole body, whose symbols then carry no number.
    fn work<W: Worksheet>(&self, given: &PartGiven<W>, row: usize, sheet: W) -> Result<Piece<W>, Refusal> {
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

        let arm = shape.from_anchor(self.reference.anchor(), length).ok_or_else(|| self.without_point())?;
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
                        "From the reference point of {name} to its mass centre, in its own axes",
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
                Named("Mass centre of {name}", &self.name, Some(MERIAM.at("table D/4"))),
            )
        } else {
            centre
        };
        let (moments, products) =
            self.inertia(shape.inertia(mass, length), shape, axes, rotation, row, sheet);
        let named = axes.is_some() || (!turned && !shape.is_round());
        Ok(Piece { mass, centre, moments, products, named })
    }

    fn mass<W: Worksheet>(
        &self,
        given: &PartGiven<W>,
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
                    (true, _) => {
                        sheet.step(("m_h", row), "kg", -*mass, named("Mass of {name}, which is taken away"))
                    }
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
            _ => return Err(self.misfilled()),
        };
        Ok(if hole {
            sheet.step(("m", row), "kg", -(density * extent), named("Mass of {name}, which is taken away"))
        } else {
            sheet.step(("m", row), "kg", density * extent, named("Mass of {name}"))
        })
    }

    /// The own axes in the frame of the body: of a shape of revolution the third one only. `None` where they lie
    /// along x, y and z in some order.
    fn axes<W: Worksheet>(
        &self,
        given: &PartGiven<W>,
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
                (Direction::Axis { .. }, DirectionGiven::Axis { axis }, _) => {
                    sheet.step_vector(("λ", row), "1", *axis / axis.magnitude(), reason)
                }
                _ => sheet.found_vector(("λ", row), "1", column(2), reason),
            };
            return Some([axis; 3]);
        }
        if (0..3).all(|n| lies_along(column(n))) {
            return None;
        }
        let axis = |n: usize, symbol: &'static str, reason: &'static str| {
            sheet.found_vector((symbol, row), "1", column(n), named(reason))
        };
        Some([
            axis(0, "e_1", "Direction of the own x axis of {name}"),
            axis(1, "e_2", "Direction of the own y axis of {name}"),
            axis(2, "e_3", "Direction of the own z axis of {name}"),
        ])
    }

    /// Moments and products about the axes of the body through the mass centre of the part.
    fn inertia<W: Worksheet>(
        &self,
        own: OwnInertia<W::Num>,
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
        let [x, y, z] = own.moments;
        if shape.is_ball() {
            let any = table("I_G", x, "Moment of inertia of {name} about any axis through its mass centre");
            return ([any; 3], [None; 3]);
        }
        if shape.is_round() {
            let across =
                table("I_t", x, "Moment of inertia of {name} across its axis, about its mass centre");
            let along = table("I_a", z, "Moment of inertia of {name} about its own axis");
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
                    why("Moment of inertia of {name} about an axis of the body through its mass centre, from its direction cosines", "App. B/2"),
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
        let reason = "Moment of inertia of {name} about an axis of its own through its mass centre";
        let moments =
            [table(names.0[0], x, reason), table(names.0[1], y, reason), table(names.0[2], z, reason)];
        let products = own.products.map_or([None; 3], |[yz, zx, xy]| {
            let reason = "Product of inertia of {name} in its own axes through its mass centre";
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
                    why("Moment of inertia of {name} about an axis of the body through its mass centre, from its direction cosines", "App. B/2"),
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
        // Of a shape of revolution the third axis alone counts: its mass centre and its ends lie on it.
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
