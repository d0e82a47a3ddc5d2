//! Whatever way instrument and technician count phase and angles, a correction ends up at the same place of the rotor.
//!
//! A rotor with a known unbalance is simulated: readings as each instrument shows them, trial weights as each technician
//! writes them down. What the analysis answers is turned back into a place on the rotor, and compared with the unbalance.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Draft, Solution, Stop, find, nalgebra::Complex};

use crate::number;

/// The habits of an instrument and a technician.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a habit with two ways, combined with all others")]
struct Habits {
    lag: bool,
    against: bool,
    counterclockwise: bool,
    opposite_end: bool,
    /// The mark on the technician's scale, deg.
    mark: f64,
    /// The sensors from the pickup with the rotation, deg.
    sensors: [f64; 2],
}

/// Response of the bearings to a unit of unbalance in each plane, along a sensor that stands at the pickup.
const RESPONSE: [[(f64, f64); 2]; 2] = [[(0.12, -35.0), (0.04, -60.0)], [(0.035, -50.0), (0.10, -42.0)]];
/// Unbalances of the planes: grams at the radius, degrees from the mark with the rotation.
const HEAVY: [(f64, f64); 2] = [(62.0, 140.0), (35.0, 255.0)];
/// Trial weights of the runs, counted in the same way.
const TRIALS: [(f64, f64); 2] = [(25.0, 20.0), (30.0, 110.0)];

fn polar((size, degrees): (f64, f64)) -> Complex<f64> {
    Complex::from_polar(size, degrees.to_radians())
}

fn all_habits() -> Vec<Habits> {
    let mut all = Vec::new();
    for bits in 0..16_u8 {
        let is = |bit: u8| bits & (1 << bit) != 0;
        for mark in [0.0, 75.0] {
            for sensors in [[0.0, 0.0], [90.0, 200.0]] {
                let (lag, against, counterclockwise, opposite_end) = (is(0), is(1), is(2), is(3));
                all.push(Habits { lag, against, counterclockwise, opposite_end, mark, sensors });
            }
        }
    }
    all
}

impl Habits {
    /// Amplitude and phase as the instrument shows them, with these weights on the rotor.
    ///
    /// A sensor that is further on in the direction of rotation sees the same spot later: its phase leads less.
    fn reading(&self, sensor: usize, weights: [Complex<f64>; 2]) -> (f64, f64) {
        let unbalance = |plane: usize| polar(HEAVY[plane]) + weights[plane];
        let at_pickup: Complex<f64> =
            (0..2).map(|plane| polar(RESPONSE[sensor][plane]) * unbalance(plane)).sum();
        let lead = at_pickup.arg() - self.sensors[sensor].to_radians();
        (at_pickup.norm(), if self.lag { -lead } else { lead })
    }

    /// An angle from the mark with the rotation as the technician writes it, deg.
    fn written(&self, from_mark: f64) -> f64 {
        self.mark + if self.against { -from_mark } else { from_mark }
    }

    /// The place on the rotor of an angle that is written so, rad from the mark with the rotation.
    fn place(&self, written: f64) -> f64 {
        let apart = written - self.mark.to_radians();
        if self.against { -apart } else { apart }
    }

    fn solved(&self) -> Solution {
        let entry = find("balancing/field").expect("the analysis is linked");
        let shape = entry.shape();
        let mut draft = Draft::blank(&shape);
        let mut set = |path: &str, text: &str| {
            draft.set(&shape, path, text).unwrap_or_else(|error| panic!("{path}: {error}"));
        };
        set("method", "least-squares");
        set("phase", if self.lag { "lag" } else { "lead" });
        set("angles", if self.against { "against" } else { "with" });
        set("view.rotation", if self.counterclockwise { "counterclockwise" } else { "clockwise" });
        set("view.end", if self.opposite_end { "opposite" } else { "drive" });
        set("view.mark", &format!("{} deg", self.mark));
        set("measured.influence.runs.after", "taken-off");
        let none = Complex::ZERO;
        for sensor in 0..2 {
            let row = sensor + 1;
            set(&format!("view.sensors[{row}].angle"), &format!("{} deg", self.sensors[sensor]));
            let mut write = |path: String, (amplitude, phase): (f64, f64)| {
                set(&format!("{path}[{row}].amplitude"), &format!("{amplitude} mm/s"));
                set(&format!("{path}[{row}].phase"), &format!("{phase} rad"));
            };
            write("measured.first".into(), self.reading(sensor, [none, none]));
            for run in 0..2 {
                let mut on = [none, none];
                on[run] = polar(TRIALS[run]);
                let path = format!("measured.influence.runs.runs[{}].readings", run + 1);
                write(path, self.reading(sensor, on));
            }
        }
        for (run, (mass, angle)) in (1..).zip(TRIALS) {
            let row = format!("measured.influence.runs.runs[{run}]");
            set(&format!("{row}.plane"), &run.to_string());
            set(&format!("{row}.mass"), &format!("{mass} g"));
            set(&format!("{row}.angle"), &format!("{} deg", self.written(angle)));
        }
        let record = draft.read(&shape).unwrap_or_else(|errors| panic!("{errors:?}"));
        entry.solve(&record, &Stop::new()).unwrap_or_else(|error| panic!("{error:?}"))
    }
}

fn same_direction(one: f64, other: f64) -> bool {
    let apart = (one - other).rem_euclid(TAU);
    apart.min(TAU - apart) < 1e-9
}

#[test]
fn every_habit_leads_to_the_same_place_on_the_rotor() {
    let habits = all_habits();
    assert_eq!(habits.len(), 64);
    for habits in habits {
        let solution = habits.solved();
        for (n, (mass, heavy)) in (1..).zip(HEAVY) {
            let opposite = heavy.to_radians() + PI;
            let place = habits.place(number(&solution, &format!("correction_angle[{n}]")));
            assert!(same_direction(place, opposite), "{habits:?}: plane {n} at {}", place.to_degrees());
            let from_mark = number(&solution, &format!("from_mark[{n}]"));
            assert!(
                same_direction(from_mark, opposite),
                "{habits:?}: {} from the mark",
                from_mark.to_degrees()
            );
            let found = number(&solution, &format!("correction[{n}]")) * 1e3;
            assert!((found - mass).abs() < 1e-6 * mass, "{habits:?}: {found} g");
        }
    }
}

/// The spot under a sensor at the moment of its peak is one place of the rotor, however it is counted. It depends on where
/// the sensors stand by nothing else than the response there, which is that at the pickup here.
#[test]
fn every_habit_leads_to_the_same_high_spots() {
    for habits in all_habits() {
        let solution = habits.solved();
        for sensor in 0..2 {
            let at_pickup: Complex<f64> =
                (0..2).map(|plane| polar(RESPONSE[sensor][plane]) * polar(HEAVY[plane])).sum();
            let spot = habits.place(number(&solution, &format!("high_spot[{}]", sensor + 1)));
            assert!(same_direction(spot, at_pickup.arg()), "{habits:?}: {}", spot.to_degrees());
        }
    }
}
