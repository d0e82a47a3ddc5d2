//! Mass, centre of mass and inertia of a body, written down step by step.

use dalembert_core::{Cite, Reason, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, MassProperties},
};
use nalgebra::Vector3;

use super::{Body, BodyGiven, BodyPart, BodyPartGiven, TakenAbout, TakenAboutGiven};
use crate::{shared::common_errors::AS_DISC, sources::MERIAM};

/// A body on a worksheet.
pub(crate) struct WorkedBody<W: Worksheet> {
    /// Mass.
    pub(crate) mass: W::Num,
    /// Position of the centre of mass.
    pub(crate) centre: W::Vec,
    /// Moments of inertia about the axes through G: Iₓ, I_y, I_z.
    pub(crate) moments: [W::Num; 3],
    /// Products of inertia I_yz, I_zx, I_xy, `I_xy = ∫ xy dm`.
    pub(crate) products: [W::Num; 3],
    /// The same by tensors alone.
    pub(crate) properties: MassProperties,
}

/// A part on a worksheet; what is exactly zero is left out.
pub(super) struct WorkedPart<W: Worksheet> {
    pub(super) mass: W::Num,
    pub(super) centre: W::Vec,
    pub(super) moments: [Option<W::Num>; 3],
    pub(super) products: [Option<W::Num>; 3],
    /// True if these carry the symbols of the axes of the body.
    pub(super) named: bool,
}

/// A reason that names a part; written only where somebody reads it.
pub(super) struct Named<'a>(pub(super) &'static str, pub(super) &'a str, pub(super) Option<Cite>);

impl From<Named<'_>> for Reason {
    fn from(Named(reason, name, cite): Named<'_>) -> Self {
        Reason { reason: Text::new(reason).with("name", name), cite }
    }
}

/// The pairs of axes that the products of inertia stand for: yz, zx, xy.
pub(crate) const PAIRS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];
pub(super) const MOMENTS: [&str; 3] = ["I_x", "I_y", "I_z"];
pub(super) const PRODUCTS: [&str; 3] = ["I_yz", "I_zx", "I_xy"];

impl<W: Worksheet> WorkedBody<W> {
    /// Angular momentum about the centre of mass of the body turning at `ω`, or a row of the inertia matrix for each
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
        less(less(moments[1] * y, xy, x), yz, z),
        less(less(moments[2] * z, zx, x), yz, y),
    )
}

/// Declares the errors with the products of inertia in the moment about a line, the next step of a symbol.
pub(crate) fn product_errors<W: Worksheet>(
    symbol: &'static str,
    body: &WorkedBody<W>,
    along: W::Vec,
    sheet: W,
) {
    let about = |products: [W::Num; 3]| about_line(body.moments, products, along);
    sheet.common_error(symbol, "the products of inertia ignored", || about([0.0.into(); 3]));
    sheet.common_error(symbol, "the products of inertia taken with the opposite sign", || {
        about(body.products.map(|product| -product))
    });
}

/// Declares the error of an angular momentum that is not projected on the axis, the next step of `H_λ`.
pub(crate) fn projection_error<W: Worksheet>(momentum: W::Vec, along: W::Vec, sheet: W) {
    if momentum.cross(along).magnitude().holds(|size| size > 0.0) {
        sheet.common_error("H_λ", "the whole angular momentum about the point taken", || {
            momentum.magnitude()
        });
    }
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
    /// Writes down the mass, the centre of mass and the inertia about it.
    ///
    /// # Errors
    /// A refusal that names the part.
    pub(crate) fn work<W: Worksheet>(
        &self,
        given: &BodyGiven<W>,
        sheet: W,
    ) -> Result<WorkedBody<W>, Refusal> {
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
                        "Parallel-axis theorem, back to G: less m times the square of the distance between the axes"
                    }
                    None => "Moment of inertia as given, about an axis through G",
                };
                let moment = |n: usize| {
                    let value = match arm.and_then(|arm| transferred(*mass, arm, n)) {
                        Some(shift) => from[n] - shift,
                        None => from[n],
                    };
                    if let Some(arm) = arm {
                        sheet.common_error(MOMENTS[n], WHOLE_DISTANCE, || from[n] - *mass * arm.dot(arm));
                    }
                    sheet.step(MOMENTS[n], "kg*m^2", value, (reason, MERIAM.at("App. B/1")))
                };
                let moments = [moment(0), moment(1), moment(2)];
                let product = |n: usize| match arm.and_then(|arm| crossed(*mass, arm, n)) {
                    Some(shift) => sheet.step(
                        PRODUCTS[n],
                        "kg*m^2",
                        known[n] - shift,
                        ("Product of inertia, transferred to G in the same way", MERIAM.at("App. B/2")),
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
                    sheet.common_error(MOMENTS[n], AS_DISC, || rigid::disc_axial_inertia(*mass, radii[n]));
                    sheet.step(
                        MOMENTS[n],
                        "kg*m^2",
                        *mass * radii[n].powi(2),
                        ("Moment of inertia from its radius of gyration", MERIAM.at("App. B/1")),
                    )
                };
                let moments = [moment(0), moment(1), moment(2)];
                let none = |n: usize| sheet.numerical(PRODUCTS[n], "kg*m^2", 0.0, NO_PRODUCT);
                (*mass, *centre, moments, [none(0), none(1), none(2)])
            }
            _ => return Err(Refusal::because("the body is not defined")),
        };
        let mass = match self {
            Body::Parts { .. } => mass,
            _ => sheet.step("m", "kg", mass, "Mass of this body"),
        };
        let centre = match self {
            Body::Parts { .. } => centre,
            _ => sheet.step_vector("r_G", "m", centre, "Position of the centre of mass G"),
        };
        let worked = WorkedBody { mass, centre, moments, products, properties };
        sheet.verify(|| worked.check(sheet));
        Ok(worked)
    }
}

const WHOLE_DISTANCE: &str = "the distance of the points used in place of that of the parallel axes";
const FROM_ORIGIN: &str = "the distances of the parts measured from the origin O";

const NO_PRODUCT: &str = "No product of inertia: the axes through G are principal";

impl<W: Worksheet> WorkedBody<W> {
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
            "the inertia matrix from the sum of the rotated and shifted tensors R I Rᵀ + m (d² 1 − d dᵀ)",
            off.fold(0.0, f64::max).into(),
            size,
        );
        sheet.check_zero(
            "the centre of mass from the tensors",
            (self.centre.value() - self.properties.centre).norm().into(),
            self.properties.centre.norm().max((size / self.properties.mass).sqrt()),
        );
        sheet.check("the total mass of the parts", self.mass, self.properties.mass.into());
    }
}

type Whole<W> =
    (<W as Worksheet>::Num, <W as Worksheet>::Vec, [<W as Worksheet>::Num; 3], [<W as Worksheet>::Num; 3]);

/// The body of the parts: one alone, or the sum of all by the theorem of parallel axes.
fn composed<W: Worksheet>(
    parts: &[BodyPart],
    given: &[BodyPartGiven<W>],
    sheet: W,
) -> Result<Whole<W>, Refusal> {
    let sole = parts.len() == 1;
    let mut pieces = Vec::with_capacity(parts.len());
    for (row, (part, given)) in (1..).zip(parts.iter().zip(given)) {
        pieces.push(part.work(given, if sole { 0 } else { row }, sheet)?);
    }
    let zero = |symbol: &'static str, why: &'static str| sheet.numerical(symbol, "kg*m^2", 0.0, why);
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
                "A line has no moment of inertia about itself, nor a particle about its own position",
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
        ("Centre of mass G: the mean of the centres of mass, weighted with the masses", MERIAM.at("§4/2")),
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
                Named("From G to the centre of mass of {name}", &part.name, None),
            )
        })
        .collect();
    let together = |own: &dyn Fn(&WorkedPart<W>) -> Option<W::Num>,
                    shift: &dyn Fn(&WorkedPart<W>, W::Vec) -> Option<W::Num>| {
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
            Some(sum) => {
                let wrong =
                    |what: &'static str,
                     own: &dyn Fn(&WorkedPart<W>) -> Option<W::Num>,
                     shift: &dyn Fn(&WorkedPart<W>, W::Vec) -> Option<W::Num>| {
                        sheet.common_error(MOMENTS[n], what, || together(own, shift).unwrap_or(sum));
                    };
                let own = |piece: &WorkedPart<W>| piece.moments[n];
                wrong("the parallel-axis terms of all parts omitted", &own, &|_, _| None);
                wrong("all parts taken as particles at their centres of mass", &|_| None, &|piece, arm| {
                    transferred(piece.mass, arm, n)
                });
                wrong(FROM_ORIGIN, &own, &|piece, _| transferred(piece.mass, piece.centre, n));
                wrong(WHOLE_DISTANCE, &own, &|piece, arm| Some(piece.mass * arm.dot(arm)));
                sheet.step(
                    MOMENTS[n],
                    "kg*m^2",
                    sum,
                    (
                        "Moment of inertia about an axis through G: those of the parts, by the parallel-axis theorem",
                        MERIAM.at("App. B/1"),
                    ),
                )
            }
            None => zero(MOMENTS[n], "All parts lie on the axis"),
        }
    };
    let product = |n: usize| {
        let sum = together(&|piece| piece.products[n], &|piece, arm| crossed(piece.mass, arm, n));
        match sum {
            Some(sum) => {
                sheet.common_error(PRODUCTS[n], FROM_ORIGIN, || {
                    let shift = |piece: &WorkedPart<W>, _: W::Vec| crossed(piece.mass, piece.centre, n);
                    together(&|piece| piece.products[n], &shift).unwrap_or(sum)
                });
                sheet.step(
                    PRODUCTS[n],
                    "kg*m^2",
                    sum,
                    ("Product of inertia about G, I_xy = ∫ xy dm; it enters the inertia matrix with a minus sign", MERIAM.at("App. B/2")),
                )
            }
            None => zero(PRODUCTS[n], NO_PRODUCT),
        }
    };
    let moments = [moment(0), moment(1), moment(2)];
    Ok((mass, centre, moments, [product(0), product(1), product(2)]))
}

/// Parallel-axis term of a moment of inertia for a mass at an arm from the axis: `m (d_y² + d_z²)`, and cyclically.
/// Nothing is written for a component that is zero.
pub(crate) fn transferred<V: Vector>(mass: V::Scalar, arm: V, axis: usize) -> Option<V::Scalar> {
    let (a, b) = PAIRS[axis];
    let squares = [a, b].map(|n| arm.components()[n]).into_iter().filter(|part| part.value() != 0.0);
    let sum = squares.map(|part| part.powi(2)).reduce(|sum, square| sum + square)?;
    Some(mass * sum)
}

/// Parallel-axis term of a product of inertia for a mass at an arm: `m d_x d_y`, and cyclically.
pub(crate) fn crossed<V: Vector>(mass: V::Scalar, arm: V, pair: usize) -> Option<V::Scalar> {
    let (a, b) = PAIRS[pair];
    let arm = arm.components();
    (arm[a].value() != 0.0 && arm[b].value() != 0.0).then(|| mass * arm[a] * arm[b])
}

/// A moment or product of inertia and what it gains.
pub(crate) fn transferred_sum<S: Real>(own: S, gain: Option<S>) -> S {
    match gain {
        Some(gain) if own.value() == 0.0 => gain,
        Some(gain) => own + gain,
        None => own,
    }
}

/// Symbols and labels of the inertia about a point.
pub(crate) struct AboutPoint {
    /// The symbols of the moments and products.
    pub(crate) symbols: [&'static str; 6],
    /// The reason of a moment.
    pub(crate) moment: &'static str,
    /// The reason of a product.
    pub(crate) product: &'static str,
}

/// Moments and products of inertia about a point of the body, from which `arm` leads to G.
pub(crate) fn about_point<W: Worksheet>(
    body: &WorkedBody<W>,
    arm: W::Vec,
    named: &AboutPoint,
    sheet: W,
) -> [W::Num; 6] {
    let [x, y, z] = body.moments;
    let [yz, zx, xy] = body.products;
    if arm.value() == Vector3::zeros() {
        return [x, y, z, yz, zx, xy];
    }
    let moment = |own: W::Num, n: usize| {
        let value = transferred_sum(own, transferred(body.mass, arm, n));
        sheet.common_error(named.symbols[n], WHOLE_DISTANCE, || {
            transferred_sum(own, Some(body.mass * arm.dot(arm)))
        });
        sheet.step(named.symbols[n], "kg*m^2", value, (named.moment, MERIAM.at("App. B/1")))
    };
    let product = |own: W::Num, n: usize| {
        let value = transferred_sum(own, crossed(body.mass, arm, n));
        sheet.step(named.symbols[n + 3], "kg*m^2", value, (named.product, MERIAM.at("App. B/2")))
    };
    [moment(x, 0), moment(y, 1), moment(z, 2), product(yz, 0), product(zx, 1), product(xy, 2)]
}
