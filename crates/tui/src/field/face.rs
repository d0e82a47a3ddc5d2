//! The clock-face of the rotor: the rotor as the technician sees it, with the scale of the weights.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::{Ink, Locale, Text};
use dalembert_plot::dial::{ArcArrow, Dial, DialName, Spot};

use super::{FieldPage, entry, words};
use crate::problem::Problem;

/// Length of the arrow of the rotation, rad.
const ROTATION: f64 = 1.4;

/// View of the rotor: the way it turns on the screen, and the way its scale goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Face {
    /// The rotor turns clockwise.
    pub(crate) turns_clockwise: bool,
    /// Angles of weights grow clockwise.
    pub(crate) grows_clockwise: bool,
    /// The phase of the instrument grows when a weight is moved clockwise.
    pub(crate) phase_clockwise: bool,
    /// Angle of the mark on the scale.
    pub(crate) mark: f64,
}

impl Face {
    /// The face of a job, with usual conventions where nothing is chosen.
    pub(crate) fn of(problem: &Problem) -> Self {
        let is = |path: &str, at: usize| entry::chosen(problem, path).unwrap_or(0) == at;
        let turns_clockwise = is("view.rotation", 0) == is("view.end", 0);
        Self {
            turns_clockwise,
            grows_clockwise: turns_clockwise == is("angles", 0),
            phase_clockwise: turns_clockwise == is("phase", 0),
            mark: entry::si_at(problem, "view.mark").unwrap_or(0.0),
        }
    }

    /// The direction on the screen of an angle on the scale, counter-clockwise from the right: the scale begins at the top.
    pub(crate) fn direction(self, angle: f64) -> f64 {
        FRAC_PI_2 + if self.grows_clockwise { -angle } else { angle }
    }

    /// The direction on the screen that lies so far from the mark in the direction of rotation.
    pub(crate) fn after_mark(self, angle: f64) -> f64 {
        self.direction(self.mark) + if self.turns_clockwise { -angle } else { angle }
    }
}

/// The faces of a page: one for each plane where weights are to be mounted, else one or none.
/// With little room the planes share one.
pub(crate) fn faces(
    problem: &Problem,
    (page, line): (FieldPage, usize),
    is_narrow: bool,
    locale: &Locale,
) -> Vec<Dial> {
    let face = Face::of(problem);
    match page {
        FieldPage::Job | FieldPage::Check(_) | FieldPage::Report => Vec::new(),
        FieldPage::Instrument => vec![conventions(problem, face, line, locale)],
        FieldPage::Initial => vec![high_spots(problem, face, locale)],
        FieldPage::Trial(run) => vec![trial(problem, face, run, locale)],
        FieldPage::Correction(trims) => {
            let all = words::mounted(problem, trims);
            if is_narrow && all.len() > 1 {
                return vec![together(problem, face, &all, locale)];
            }
            all.iter().map(|mass| correction(problem, face, trims, mass, locale)).collect()
        }
    }
}

/// Rim, scale, mark and direction of rotation; of what is not answered yet nothing is drawn.
fn rotor(problem: &Problem, face: Face, title: &Text, locale: &Locale) -> Dial {
    let turns = entry::chosen(problem, "view.rotation").is_some();
    let grows = turns && entry::chosen(problem, "angles").is_some();
    let ticks = (0..12).map(|tick| f64::from(tick) * PI / 6.0).collect();
    let scale = |quarter: i32| DialName {
        direction: face.direction(f64::from(quarter) * FRAC_PI_2),
        words: if locale.style.ascii { (90 * quarter).to_string() } else { format!("{}°", 90 * quarter) },
        ink: Ink::Faint,
    };
    // 0° and 180° have their places whichever way the scale goes.
    let mut names: Vec<DialName> = (0..4).filter(|quarter| grows || quarter % 2 == 0).map(scale).collect();
    let mark = face.direction(face.mark);
    names.push(DialName { direction: mark, words: Text::from("mark").render(locale), ink: Ink::Motion });
    let sense = if face.turns_clockwise { -1.0 } else { 1.0 };
    let rotation = ArcArrow {
        radius: 0.64,
        from: -FRAC_PI_2 - sense * ROTATION / 2.0,
        sweep: sense * ROTATION,
        words: Text::from("rotor turns").render(locale),
        ink: Ink::Motion,
    };
    let spot = Spot { direction: mark, distance: 1.0, sign: ('◆', 'v'), ink: Ink::Motion };
    Dial {
        title: title.render(locale),
        ticks,
        names,
        hands: Vec::new(),
        spots: vec![spot],
        arrows: if turns { vec![rotation] } else { Vec::new() },
    }
}

/// From where the rotor is seen.
fn seen_from(problem: &Problem) -> Text {
    match entry::chosen(problem, "view.end") {
        Some(1) => "Seen from the opposite end".into(),
        _ => "Seen from the drive end".into(),
    }
}

fn plane_seen(problem: &Problem, plane: usize) -> Text {
    let said = match entry::chosen(problem, "view.end") {
        Some(1) => "Plane {n} from the opposite end",
        _ => "Plane {n} from the drive end",
    };
    Text::new(said).with("n", plane)
}

/// The habits of instrument and technician; that of the line under the cursor is pointed out.
fn conventions(problem: &Problem, face: Face, line: usize, locale: &Locale) -> Dial {
    let mut dial = rotor(problem, face, &seen_from(problem), locale);
    let pointed_out = match line {
        2 => Some(("angles", "angle grows", face.grows_clockwise)),
        3 => Some(("phase", "phase grows", face.phase_clockwise)),
        _ => None,
    };
    let is_answered = |path: &str| entry::chosen(problem, path).is_some();
    if let Some((path, words, clockwise)) = pointed_out
        && is_answered("view.rotation")
        && is_answered(path)
    {
        let sense = if clockwise { -1.0 } else { 1.0 };
        dial.arrows.push(ArcArrow {
            radius: 0.82,
            from: face.direction(face.mark) + sense * 0.2,
            sweep: sense * FRAC_PI_2,
            words: Text::from(words).render(locale),
            ink: Ink::Result,
        });
    }
    for sensor in 1..=entry::sensors(problem).unwrap_or(0) {
        let angle = entry::si_at(problem, &format!("view.sensors[{sensor}].angle")).unwrap_or(0.0);
        let direction = face.after_mark(angle);
        dial.names.push(DialName { direction, words: format!("S{sensor}"), ink: Ink::Force });
    }
    dial
}

fn with_high_spots(problem: &Problem, face: Face, dial: &mut Dial) {
    let spots = (1..)
        .map_while(|sensor| Some((sensor, entry::answer(problem, &format!("high_spot[{sensor}]"))?.si()?)));
    for (sensor, spot) in spots {
        let direction = face.direction(spot);
        dial.names.push(DialName { direction, words: format!("H{sensor}"), ink: Ink::Danger });
        dial.spots.push(Spot { direction, distance: 1.0, sign: ('○', 'o'), ink: Ink::Danger });
    }
}

fn high_spots(problem: &Problem, face: Face, locale: &Locale) -> Dial {
    let title = match entry::answer(problem, "high_spot[1]") {
        Some(_) => "H: high spot, nearest to the sensor at the peak".into(),
        None => seen_from(problem),
    };
    let mut dial = rotor(problem, face, &title, locale);
    with_high_spots(problem, face, &mut dial);
    dial
}

/// The trial weight of a run.
fn trial(problem: &Problem, face: Face, run: usize, locale: &Locale) -> Dial {
    let mut dial = rotor(problem, face, &plane_seen(problem, run), locale);
    let row = format!("{}[{run}]", entry::RUNS);
    if let Some(angle) = entry::si_at(problem, &format!("{row}.angle")) {
        let words = entry::in_style(entry::text_at(problem, &format!("{row}.mass")), locale.style);
        hand(&mut dial, face.direction(angle), words, Ink::Force);
    }
    with_high_spots(problem, face, &mut dial);
    dial
}

/// The mass to mount in a plane, and the trial weight if it stays on.
fn correction(
    problem: &Problem,
    face: Face,
    trims: usize,
    mass: &words::Mounted<'_>,
    locale: &Locale,
) -> Dial {
    let title = Text::new("Plane {n}: {mass} at {angle}")
        .with("n", mass.plane)
        .with("mass", words::quantity(mass.mass, locale))
        .with("angle", words::degrees(mass.angle, locale));
    let mut dial = rotor(problem, face, &title, locale);
    let stays = entry::chosen(problem, "measured.influence.runs.after") == Some(1);
    let row = (1..=entry::rows(problem, entry::RUNS))
        .map(|row| format!("{}[{row}]", entry::RUNS))
        .find(|row| entry::text_at(problem, &format!("{row}.plane")) == mass.plane.to_string());
    let trial = row.and_then(|row| entry::si_at(problem, &format!("{row}.angle")));
    if let Some(angle) = trial.filter(|_| stays && trims == 0) {
        hand(&mut dial, face.direction(angle), Text::from("trial, left on").render(locale), Ink::Force);
    }
    let direction = face.direction(mass.angle.si().unwrap_or_default());
    hand(&mut dial, direction, words::degrees(mass.angle, locale), Ink::Result);
    dial
}

/// The masses to mount in all planes.
fn together(problem: &Problem, face: Face, all: &[words::Mounted<'_>], locale: &Locale) -> Dial {
    let mut dial = rotor(problem, face, &Text::from("Planes 1, 2"), locale);
    for mass in all {
        let direction = face.direction(mass.angle.si().unwrap_or_default());
        let words = format!("{}: {}", mass.plane, words::degrees(mass.angle, locale));
        hand(&mut dial, direction, words, Ink::Result);
    }
    dial
}

/// A weight: a hand to it, and what it is.
fn hand(dial: &mut Dial, direction: f64, words: String, ink: Ink) {
    dial.hands.push((direction, ink));
    dial.spots.push(Spot { direction, distance: 1.0, sign: ('●', '@'), ink });
    dial.names.push(DialName { direction, words, ink });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spot so far from the mark in the direction of rotation is drawn there, whichever way it is counted.
    #[test]
    fn a_spot_is_drawn_at_its_place_however_it_is_counted() {
        for bits in 0..8_u8 {
            let is = |bit: u8| bits & (1 << bit) != 0;
            let (turns_clockwise, with, phase_clockwise) = (is(0), is(1), is(2));
            for mark in [0.0, 75_f64.to_radians()] {
                let grows_clockwise = turns_clockwise == with;
                let face = Face { turns_clockwise, grows_clockwise, phase_clockwise, mark };
                for degrees in [0.0_f64, 30.0, 140.0, 288.0] {
                    let from_mark = degrees.to_radians();
                    let written = mark + if with { from_mark } else { -from_mark };
                    let apart = face.direction(written) - face.direction(mark);
                    let wanted = if turns_clockwise { -from_mark } else { from_mark };
                    assert!((apart - wanted).abs() < 1e-12, "{face:?}: {degrees}°");
                    assert!((face.after_mark(from_mark) - face.direction(written)).abs() < 1e-12);
                }
            }
        }
    }
}
