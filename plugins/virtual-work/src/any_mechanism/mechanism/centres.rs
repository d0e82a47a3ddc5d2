//! The instant centres of a mechanism.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyFrame, InstantCentre};

use super::Solved;
use crate::shared::parts::verbatim;

/// Of more bodies than these, only the centres against the ground are listed.
const MOST_BODIES: usize = 8;

impl Solved<'_> {
    /// The instant centre of every two parts of a driven mechanism, the ground included.
    ///
    /// With one driver they rest on the position alone, and are those of its virtual motion.
    pub(super) fn table_of_centres(&self) -> TableExhibit {
        let drivers = &self.system.mechanism().drivers;
        let (velocities, title): (&[[f64; 3]], &'static str) = match &self.dynamics.coefficients[..] {
            [only] => (only, "Instant centres"),
            [first, ..] if drivers.iter().all(|driver| driver.velocity == 0.0) => {
                (first, "Instant centres when only the first driver moves")
            }
            _ => (&self.state.velocities, "Instant centres for the given motion of the drivers"),
        };
        let bodies = self.parts.bodies.len();
        let against_ground = (0..bodies).map(|body| [None, Some(body)]);
        let others = if bodies > MOST_BODIES { 0 } else { bodies };
        let of_bodies = (0..others).flat_map(|a| (a + 1..bodies).map(move |b| [Some(a), Some(b)]));
        let row = |parts: [BodyFrame; 2]| {
            let centre = self.system.instant_centre(parts, &self.state.positions, velocities);
            let [x, y, otherwise] = cells(centre, self.system.size());
            let [one, other] = parts.map(|part| self.name_of(part));
            let pair = Text::new("{one} and {other}").with_text("one", one).with_text("other", other);
            vec![Cell::Text(pair), x, y, otherwise]
        };
        TableExhibit {
            title: title.into(),
            columns: vec![
                Column { heading: "Parts".into(), unit: "" },
                Column { heading: "x".into(), unit: "mm" },
                Column { heading: "y".into(), unit: "mm" },
                Column { heading: "Remark".into(), unit: "" },
            ],
            rows: against_ground.chain(of_bodies).map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// Name of a part.
    pub(super) fn name_of(&self, part: BodyFrame) -> Text {
        part.map_or("the ground".into(), |body| verbatim(&self.parts.bodies[body].name))
    }
}

/// x and y of a centre, or why it has none; what is rounding beside `size` is zero.
fn cells(centre: InstantCentre, size: f64) -> [Cell; 3] {
    match centre {
        InstantCentre::At(at) => {
            let largest = at.iter().fold(size, |most, x| most.max(x.abs()));
            let [x, y] = at.map(|x| Cell::Number(if x.abs() < 1e-12 * largest { 0.0 } else { x }));
            [x, y, Cell::Empty]
        }
        InstantCentre::Far(direction) => {
            let words = Text::new("at infinity, in the direction {angle}");
            [Cell::Empty, Cell::Empty, Cell::Text(words.with_quantity("angle", line(direction), "deg"))]
        }
        InstantCentre::Everywhere => {
            [Cell::Empty, Cell::Empty, "they do not move relative to each other".into()]
        }
    }
}

/// The angle of a line without sense, above −90° and up to 90°.
fn line([x, y]: [f64; 2]) -> f64 {
    const ROUNDING: f64 = 1e-12;
    let angle = y.atan2(x);
    let turned = if angle > FRAC_PI_2 + ROUNDING {
        angle - PI
    } else if angle <= ROUNDING - FRAC_PI_2 {
        angle + PI
    } else {
        angle
    };
    if turned.abs() < ROUNDING { 0.0 } else { turned }
}
