//! A rigid body: mass, centre of mass and inertia, about any point and any line.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, Principal},
};
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::{
        body::{
            AboutPoint, Body, BodyLine, BodyLineGiven, BodyPart, PAIRS, WorkedBody, about_line, about_point,
            product_errors, refused,
        },
        flat,
        scene::Scene,
    },
    sources::{BEER, MERIAM, RIUL},
};

/// A rigid body, and the point and the line about which its inertia is asked.
///
/// The axes xyz are fixed in the body, with their origin O wherever it is convenient.
#[derive(Clone, Debug, Inputs)]
pub struct MassProperties {
    /// Body.
    pub body: Body,
    /// Position of a point A.
    /// The inertia about the axes through it is also calculated.
    #[input("r_A", "m", default = "(0; 0; 0) m")]
    pub point: Vector3<f64>,
    /// A line.
    /// The moment of inertia about it is calculated.
    pub line: Option<BodyLine>,
}

register!(MassProperties);

impl Analysis for MassProperties {
    const ABOUT: About = About {
        id: "rigid-body/mass-properties",
        title: "Mass, centre of mass and inertia of a body",
        topic: "Inertia and momentum",
        summary: "Centre of mass, moments and products of inertia, principal axes of a composite body, about any point and line.",
        main: &["centre", "inertia_x", "inertia_y", "inertia_z"],
        keywords: "moment of inertia product of inertia tensor matrix principal axes centroid centre of mass composite steiner parallel axis \
                   radius of gyration momento de inércia produto de inércia centro de massa eixos principais raio de giração teorema dos eixos paralelos corpo composto",
        sources: &[&MERIAM, &BEER, &RIUL],
        cases: include_str!("../../cases/mass_properties.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MassPropertiesGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = self.body.work(&given.body, sheet)?;
        sheet.answer("mass", "Mass", body.mass);
        sheet.answer_vector("centre", "Position of the centre of mass G", body.centre);
        let names = ["inertia_x", "inertia_y", "inertia_z", "product_yz", "product_zx", "product_xy"];
        for (n, (name, value)) in
            names.into_iter().zip(body.moments.into_iter().chain(body.products)).enumerate()
        {
            sheet.answer(name, ABOUT_G[n], value);
        }
        self.radii(&body, sheet);
        let principal = body.properties.check().map_err(|error| refused(&error, "this body"))?;
        show_principal(&body, &principal, sheet);
        let arm = sheet.step_vector("d_A", "m", body.centre - given.point, "From A to G");
        let about = about_point(&body, arm, &POINT_A, sheet);
        let names = [
            "point_inertia_x",
            "point_inertia_y",
            "point_inertia_z",
            "point_product_yz",
            "point_product_zx",
            "point_product_xy",
        ];
        for (n, (name, value)) in names.into_iter().zip(about).enumerate() {
            sheet.answer(name, ABOUT_A[n], value);
        }
        sheet.verify(|| {
            let tensor = body.properties.inertia_about(self.point);
            let off = (0..3).map(|n| {
                let (a, b) = PAIRS[n];
                let moment = about[n].value() - tensor[(n, n)];
                moment.abs().max((about[n + 3].value() + tensor[(a, b)]).abs())
            });
            sheet.check_zero(
                "the inertia about A from the tensor I + m (d² 1 − d dᵀ)",
                off.fold(0.0, f64::max).into(),
                tensor.amax(),
            );
        });
        if let (Some(line), Some(given)) = (&self.line, &given.line) {
            line.inertia(&body, given, sheet)?;
        }
        sheet.show(|| Exhibit::Table(matrix("Inertia matrix about G", &body.properties.inertia)));
        if let Body::Parts { parts } = &self.body
            && parts.len() > 1
        {
            sheet.show(|| Exhibit::Table(listed(parts, &body.properties)));
        }
        sheet.show(|| self.drawn(&body.properties, &principal));
        sheet.show(|| Exhibit::Plot(turned_axes(&principal)));
        Ok(())
    }
}

const ABOUT_G: [&str; 6] = [
    "Moment of inertia about the x axis through G",
    "Moment of inertia about the y axis through G",
    "Moment of inertia about the z axis through G",
    "Product of inertia I_yz about G",
    "Product of inertia I_zx about G",
    "Product of inertia I_xy about G",
];

const ABOUT_A: [&str; 6] = [
    "Moment of inertia about the x axis through A",
    "Moment of inertia about the y axis through A",
    "Moment of inertia about the z axis through A",
    "Product of inertia I_yz about A",
    "Product of inertia I_zx about A",
    "Product of inertia I_xy about A",
];

const POINT_A: AboutPoint = AboutPoint {
    symbols: ["I_Ax", "I_Ay", "I_Az", "I_Ayz", "I_Azx", "I_Axy"],
    moment: "Parallel-axis theorem: moment of inertia about an axis through A",
    product: "Parallel-axis theorem: product of inertia about A",
};

/// Principal moments and axes.
fn show_principal<W: Worksheet>(body: &WorkedBody<W>, principal: &Principal, sheet: W) {
    let tensor = body.properties.inertia;
    for n in 0..3 {
        let reason = if n == 0 {
            "Principal moment of inertia: the roots of det(I − λ 1) = 0 in ascending order"
        } else {
            "The next root"
        };
        if body.products.iter().any(|product| product.holds(|x| x != 0.0)) {
            sheet.common_error(("I_p", n + 1), "the products of inertia ignored", || {
                let [x, y, z] = body.moments;
                let (least, most) = (x.min(y).min(z), x.max(y).max(z));
                [least, x + y + z - least - most, most][n]
            });
        }
        let moment =
            sheet.numerical(("I_p", n + 1), "kg*m^2", principal.moments[n], (reason, MERIAM.at("App. B/2")));
        let axis = sheet.numerical_vector(
            ("u", n + 1),
            "1",
            principal.axis(n),
            ("Its axis: the direction u in which I u = λ u", MERIAM.at("App. B/2")),
        );
        sheet.answer(("principal_inertia", n + 1), "Principal moment of inertia", moment);
        sheet.answer_vector(("principal_axis", n + 1), "Its axis", axis);
        sheet.verify(|| {
            let (moment, axis) = (moment.value(), axis.value());
            let left = tensor * axis - axis * moment;
            sheet.check(
                Text::new("the principal axis {n} has length one").with("n", n + 1),
                W::Num::from(axis.norm_squared()),
                W::Num::from(1.0),
            );
            sheet.check_zero("the principal axis from I u − λ u = 0", left.norm().into(), tensor.amax());
        });
    }
    sheet.verify(|| {
        let [x, y, z] = body.moments.map(Real::value);
        sheet.check_zero(
            "the principal moments from their sum, which is Iₓ + I_y + I_z",
            (principal.moments.sum() - (x + y + z)).into(),
            tensor.amax(),
        );
    });
    let [first, second, third] = [0, 1, 2].map(|n| principal.moments[n]);
    if third > 0.0 && third - first <= 1e-9 * third {
        sheet.warn(|| Text::new("all principal moments are equal: every axis through G is a principal axis"));
    } else if let Some(alone) = principal.symmetry_axis() {
        sheet.warn(|| {
            Text::new("two principal moments are equal: every axis through G normal to the principal axis {n} is a principal axis")
                .with("n", alone + 1)
        });
    }
    if third > 0.0 && (first + second - third).abs() <= 1e-9 * third && first > 0.0 {
        sheet.warn(|| Text::new("the largest principal moment is the sum of the others: the body is flat"));
    }
}

impl MassProperties {
    fn radii<W: Worksheet>(&self, body: &WorkedBody<W>, sheet: W) {
        let names = [
            ("k_x", "radius_x", "Radius of gyration about the x axis through G"),
            ("k_y", "radius_y", "Radius of gyration about the y axis through G"),
            ("k_z", "radius_z", "Radius of gyration about the z axis through G"),
        ];
        let radii = names.into_iter().zip(body.moments).map(|((symbol, name, label), moment)| {
            // A moment that is rounding alone may be below zero.
            let radius = if moment.value() > 1e-14 * body.properties.inertia.amax() {
                sheet.step(symbol, "m", (moment / body.mass).sqrt(), (label, MERIAM.at("App. B/1")))
            } else {
                sheet.numerical(symbol, "m", 0.0, (label, MERIAM.at("App. B/1")))
            };
            sheet.answer(name, label, radius);
            radius
        });
        let radii: Vec<W::Num> = radii.collect();
        sheet.verify(|| {
            let squares = W::Num::sum(radii.into_iter().map(|radius| radius.powi(2)));
            let trace = body.properties.inertia.trace();
            sheet.check(
                "the radii of gyration from the trace of the tensor",
                body.mass * squares,
                trace.into(),
            );
        });
    }

    fn drawn(&self, body: &rigid::MassProperties, principal: &Principal) -> Exhibit {
        let mut scene = Scene::new();
        let size = self.body.draw(&mut scene, body, principal);
        let mut letters = ["x", "y", "z"].map(Some);
        for (n, name) in ["1", "2", "3"].into_iter().enumerate() {
            let axis = principal.axis(n);
            // A principal axis along an axis of the body through G is one arrow with both names.
            let is_along = |along: &usize| {
                let off = body.centre - Vector3::ith(*along, body.centre[*along]);
                axis[*along] > 1.0 - 1e-9 && off.norm() < 1e-6 * size
            };
            match (0..3).find(is_along).and_then(|along| letters[along].take()) {
                Some(letter) => {
                    scene.line([Vector3::zeros(), body.centre], Ink::Faint);
                    scene.arrow(
                        body.centre,
                        axis * (0.8 * size),
                        Ink::Result,
                        flat::letters(&[letter, name]),
                    );
                }
                None => scene.arrow(body.centre, axis * (0.5 * size), Ink::Result, name),
            }
        }
        for (n, letter) in letters.into_iter().enumerate() {
            if let Some(letter) = letter {
                scene.arrow(Vector3::zeros(), Vector3::ith(n, 0.7 * size), Ink::Faint, letter);
            }
        }
        scene.label(body.centre, "G");
        if self.point != Vector3::zeros() {
            scene.label(self.point, "r_A");
        }
        if let Some(line) = &self.line {
            line.draw(&mut scene, body.centre, size);
        }
        scene.exhibit("The body, its axes and its principal axes at G")
    }
}

impl BodyLine {
    fn inertia<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        given: &BodyLineGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        if !(self.direction.amax() > 0.0 && self.direction.iter().all(|x| x.is_finite())) {
            return Err(Refusal::because(
                "the line has no direction: write any vector along it, such as (1; 0; 0)",
            ));
        }
        let along = sheet.step_vector(
            "λ",
            "1",
            given.direction / given.direction.magnitude(),
            "Direction cosines of the line",
        );
        let between = along.components().into_iter().filter(|cos| cos.holds(|cos| cos != 0.0)).count() > 1;
        if between {
            product_errors("I_λ", body, along, sheet);
            sheet.common_error("I_λ", "the direction cosines not squared", || {
                let terms = body.moments.into_iter().zip(along.components());
                W::Num::sum(terms.map(|(moment, cos)| moment * cos))
            });
        }
        let through_g = sheet.step(
            "I_λ",
            "kg*m^2",
            about_line(body.moments, body.products, along),
            ("Moment of inertia about the parallel line through G", MERIAM.at("App. B/2")),
        );
        sheet.common_error("δ", "the distance of G from the given point of the line used", || {
            (body.centre - given.through).magnitude()
        });
        let distance = sheet.step(
            "δ",
            "m",
            (body.centre - given.through).cross(along).magnitude(),
            "Distance of G from the line",
        );
        let about = sheet.step(
            "I_L",
            "kg*m^2",
            through_g + body.mass * distance.powi(2),
            ("Parallel-axis theorem: moment of inertia about the line", MERIAM.at("App. B/1")),
        );
        sheet.answer("line_inertia", "Moment of inertia about the line", about);
        let radius = if about.value() > 1e-14 * body.properties.inertia.amax() {
            sheet.common_error(
                "k_L",
                "the distance of the line added to the radius of gyration about its parallel through G",
                || (through_g / body.mass).sqrt() + distance,
            );
            sheet.step("k_L", "m", (about / body.mass).sqrt(), "Radius of gyration about the line")
        } else {
            sheet.numerical("k_L", "m", 0.0, "Radius of gyration about the line")
        };
        sheet.answer("line_radius", "Radius of gyration about the line", radius);
        sheet.verify(|| {
            let Ok(second) = body.properties.inertia_about_line(self.through, self.direction) else { return };
            let size = body.properties.inertia_about(self.through).amax();
            sheet.check_sum(
                "the moment about the line from the tensor about a point of it, λ · I λ",
                about,
                second.into(),
                size,
            );
            sheet.check_sum(
                "the radius of gyration about the line from that tensor",
                body.mass * radius.powi(2),
                second.into(),
                size,
            );
        });
        Ok(())
    }
}

/// The moment of inertia about an axis through G that turns from one principal axis to the next.
fn turned_axes(principal: &Principal) -> Plot {
    let plane = |from: usize, to: usize| -> Vec<(f64, f64)> {
        (0..=90)
            .map(|n| PI * f64::from(n) / 90.0)
            .map(|angle| {
                let (sin, cos) = angle.sin_cos();
                (angle, principal.moments[from] * cos * cos + principal.moments[to] * sin * sin)
            })
            .collect()
    };
    Plot::new(
        "Moment of inertia about an axis through G that turns in a principal plane",
        Axis::linear("angle from the first axis of the plane", "deg"),
        Axis::linear("moment of inertia", "kg*m^2"),
        vec![
            Series::line("axis 1 to axis 2", plane(0, 1)),
            Series::line("axis 2 to axis 3", plane(1, 2)),
            Series::line("axis 3 to axis 1", plane(2, 0)),
        ],
    )
}

/// The inertia matrix as it multiplies ω: products with a minus sign.
pub(crate) fn matrix(title: &'static str, tensor: &Matrix3<f64>) -> TableExhibit {
    let column = |heading: &'static str| Column { heading: heading.into(), unit: "kg*m^2" };
    let clean = |x: f64| if x.abs() > 1e-14 * tensor.amax() { x } else { 0.0 };
    TableExhibit {
        title: title.into(),
        columns: vec![Column { heading: "".into(), unit: "" }, column("x"), column("y"), column("z")],
        rows: (0..3)
            .map(|n| {
                let name = Cell::from(["x", "y", "z"][n]);
                std::iter::once(name).chain((0..3).map(|k| clean(tensor[(n, k)]).into())).collect()
            })
            .collect(),
        foot: Vec::new(),
    }
}

/// Mass and centre of mass of each part.
fn listed(parts: &[BodyPart], whole: &rigid::MassProperties) -> TableExhibit {
    let row = |name: Cell, body: &rigid::MassProperties| {
        let [x, y, z] = body.centre.into();
        vec![name, body.mass.into(), x.into(), y.into(), z.into()]
    };
    let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
    TableExhibit {
        title: "The parts and the whole".into(),
        columns: vec![
            column("part", ""),
            column("m", "kg"),
            column("x_G", "m"),
            column("y_G", "m"),
            column("z_G", "m"),
        ],
        rows: parts
            .iter()
            .zip(1..)
            .filter_map(|(part, number)| {
                let name = Text::new("{number}, {name}").with("number", number).with("name", &part.name);
                Some(row(name.into(), &part.properties().ok()?))
            })
            .collect(),
        foot: row("the whole".into(), whole),
    }
}
