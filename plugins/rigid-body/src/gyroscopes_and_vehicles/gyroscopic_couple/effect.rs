//! Effect of the gyroscopic reaction on the carrier, in words.

use dalembert_core::{
    Exhibit, TableExhibit, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::{Real, Vector};

use super::RotorCarrier;

/// Components of a reaction that are this small beside the couple are rounding.
const ROUNDING: f64 = 1e-12;

/// Answers each part of the reaction under the words of its effect, and shows them in a table.
pub(super) fn answer<W: Worksheet>(carrier: RotorCarrier, reaction: W::Vec, size: W::Num, sheet: W) {
    let least = ROUNDING * size.value();
    let mut rows = Vec::new();
    for (axis, part) in reaction.components().into_iter().enumerate() {
        if part.value().abs() <= least {
            continue;
        }
        let words = words(carrier, axis, part.value() > 0.0);
        let (name, symbol) = NAMES[axis];
        let part = sheet.step(symbol, "N*m", part.abs(), words);
        sheet.answer(name, words, part);
        rows.push(vec![Cell::from(words), Cell::Number(part.value())]);
    }
    if rows.is_empty() {
        sheet.warn(|| {
            "the carrier does not turn about an axis normal to the axle, or the rotor is at rest: there is no gyroscopic couple, and no effect".into()
        });
        return;
    }
    sheet.show(|| {
        Exhibit::Table(TableExhibit {
            title: "Effect on the carrier".into(),
            columns: vec![
                Column { heading: "effect".into(), unit: "" },
                Column { heading: "couple".into(), unit: "N*m" },
            ],
            rows,
            foot: Vec::new(),
        })
    });
}

const NAMES: [(&str, &str); 3] =
    [("rolling_effect", "Cₓ"), ("pitching_effect", "C_y"), ("yawing_effect", "C_z")];

/// The effect of a couple on a carrier about its axis 0 (forward), 1 (left) or 2 (up), in the positive sense or not.
pub(super) fn words(carrier: RotorCarrier, axis: usize, positive: bool) -> &'static str {
    use RotorCarrier::{Aircraft, Frame, Ship, Vehicle};
    match (carrier, axis, positive) {
        (Ship, 0, true) => "Effect: heels the ship to starboard",
        (Ship, 0, false) => "Effect: heels the ship to port",
        (Ship, 1, true) => "Effect: lowers the bow and raises the stern",
        (Ship, 1, false) => "Effect: raises the bow and lowers the stern",
        (Ship, _, true) => "Effect: turns the bow to port and the stern to starboard",
        (Ship, _, false) => "Effect: turns the bow to starboard and the stern to port",
        (Aircraft, 0, true) => "Effect: lowers the right wing and raises the left one",
        (Aircraft, 0, false) => "Effect: lowers the left wing and raises the right one",
        (Aircraft, 1, true) => "Effect: lowers the nose and raises the tail",
        (Aircraft, 1, false) => "Effect: raises the nose and lowers the tail",
        (Aircraft, _, true) => "Effect: turns the nose to the left and the tail to the right",
        (Aircraft, _, false) => "Effect: turns the nose to the right and the tail to the left",
        (Vehicle, 0, true) => "Effect: loads the right wheels and unloads the left wheels",
        (Vehicle, 0, false) => "Effect: loads the left wheels and unloads the right wheels",
        (Vehicle, 1, true) => "Effect: loads the front wheels and unloads the rear wheels",
        (Vehicle, 1, false) => "Effect: loads the rear wheels and unloads the front wheels",
        (Vehicle, _, true) => "Effect: turns the front to the left",
        (Vehicle, _, false) => "Effect: turns the front to the right",
        (Frame, 0, true) => "Effect: tips the frame to the right",
        (Frame, 0, false) => "Effect: tips the frame to the left",
        (Frame, 1, true) => "Effect: tips the frame forward",
        (Frame, 1, false) => "Effect: tips the frame backward",
        (Frame, _, true) => "Effect: turns the frame to the left",
        (Frame, _, false) => "Effect: turns the frame to the right",
    }
}
