//! The letters of a mechanism: masses, drivers, springs and couples by the rows of the form.

use dalembert_core::{Ink, Sketch, Text};
use dalembert_mechanics::planar::Pose;

use super::{Driven, PartLoad, Parts};
use crate::shared::figure::letter;

/// Bodies whose centres of mass, masses and moments of inertia are named; letters of more would fill the drawing.
const MOST_NAMED: usize = 4;

impl Parts {
    /// Names what has a symbol in the form and no name of its own.
    pub(super) fn letters(&self, positions: &[[f64; 3]], size: f64, sketch: &mut Sketch) {
        let word = |symbol: &str, row: usize| Text::verbatim(letter(symbol, row + 1));
        for (row, body) in self.bodies.iter().enumerate().filter(|(_, body)| body.mass != 0.0) {
            let [x, y, _] = positions[row];
            let has_centre = body.centre.norm() > 0.0;
            let given = [("G", has_centre), ("m", true), ("I_G", body.inertia != 0.0)];
            let names = given.iter().filter(|(_, is_given)| *is_given && self.bodies.len() <= MOST_NAMED);
            let names: Vec<String> = names.map(|(symbol, _)| letter(symbol, row + 1)).collect();
            sketch.mass_centre(Text::verbatim(names.join(", ")), (x, y));
        }
        for (row, drive) in self.drivers.iter().enumerate() {
            match drive.what {
                Driven::Angle { body, ref against, velocity, .. } => {
                    let origin = self.origin(body.0, positions);
                    let turned = |body: usize| positions[body][2];
                    let from = against.frame().map_or(0.0, turned);
                    let reach = (origin.0 + 0.2 * size * from.cos(), origin.1 + 0.2 * size * from.sin());
                    sketch.axis(origin, reach).angle(word("θ", row), origin, from, turned(body.0));
                    if velocity != 0.0 {
                        let way = if velocity > 0.0 { (1.8, 3.1) } else { (3.1, 1.8) };
                        sketch.couple(word("ω", row), origin, way, Ink::Motion);
                    }
                }
                Driven::Position { from, to, .. } | Driven::Distance { from, to, .. } => {
                    let ends = [from, to].map(|end| self.place(end, positions));
                    sketch.dimension(word("s", row), ends[0], ends[1], 2.5);
                }
            }
        }
        for (row, load) in self.loads.iter().enumerate() {
            match &load.load {
                PartLoad::Spring { from, to, free, .. } => {
                    let [a, b] = [*from, *to].map(|end| self.place(end, positions));
                    let free =
                        if *free == 0.0 { String::new() } else { format!(", {}", letter("L_0", row + 1)) };
                    let middle = (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
                    sketch.label(Text::verbatim(letter("k", row + 1) + &free), middle);
                }
                PartLoad::Couple { on, moment, .. } if *moment != 0.0 => {
                    let Some(body) = on.frame() else { continue };
                    let way = if *moment > 0.0 { (3.4, 5.6) } else { (5.6, 3.4) };
                    sketch.couple(word("M", row), self.origin(body, positions), way, Ink::Force);
                }
                _ => {}
            }
        }
    }

    /// Origin of the axes of a body.
    fn origin(&self, body: usize, positions: &[[f64; 3]]) -> (f64, f64) {
        let centre = self.bodies[body].centre;
        let [x, y] = Pose::new(positions[body]).point([-centre.x, -centre.y]);
        (x, y)
    }
}
