//! Force and deflection of each member of a network.

use dalembert_core::{Cell, Column, Exhibit, Symbol, TableExhibit, Text, Worksheet, printer};
use dalembert_mechanics::Real;

use super::{
    Element, Joined,
    element::{SpringMotion, symbol},
};
use crate::sources::RAO;

/// Load on the network, for the forces of its members.
#[derive(Clone, Copy)]
pub(crate) enum Loaded {
    /// The whole vibrates with this amplitude, m or rad.
    Vibrating(f64),
    /// The whole is deflected at rest by this, m.
    AtRest(f64),
}

/// The share of the force and of the deflection of one single spring.
struct Share {
    symbol: Symbol,
    label: &'static str,
    stiffness: f64,
    force: f64,
    deflection: f64,
}

/// Writes the share of the force (`φ`) and of the deflection (`ψ`) of every member of a network, shows them in a
/// table, and holds the stiffness of the whole to the energy of the members, `Σ kᵢ ψᵢ² = k`.
///
/// Where it is known what loads the whole, the table has forces and deflections too.
pub(crate) fn shares<W: Worksheet>(whole: &Element<W::Num>, sheet: W, loaded: Option<Loaded>) {
    if matches!(whole.joined, Joined::Alone) {
        return;
    }
    let mut all = Vec::new();
    let one = W::Num::from(1.0);
    let mut energies = Vec::new();
    inside(whole, one, one, sheet, &mut all, &mut energies);
    sheet.check(
        "the energy in the members is the energy in the equivalent spring",
        W::Num::sum(energies),
        whole.stiffness,
    );
    let stiffness = whole.stiffness.value();
    sheet.show(|| Exhibit::Table(table(&all, whole.motion, stiffness, loaded)));
}

fn inside<W: Worksheet>(
    group: &Element<W::Num>,
    force: W::Num,
    deflection: W::Num,
    sheet: W,
    all: &mut Vec<Share>,
    energies: &mut Vec<W::Num>,
) {
    let words = Words::of(group.motion);
    let base = group.motion.symbol();
    let (members, in_series) = match &group.joined {
        Joined::Alone => {
            energies.push(group.stiffness * deflection.powi(2));
            all.push(Share {
                symbol: symbol(base, &group.place),
                label: group.label,
                stiffness: group.stiffness.value(),
                force: force.value(),
                deflection: deflection.value(),
            });
            return;
        }
        Joined::Series(members) => (members, true),
        Joined::Parallel(members) => (members, false),
        Joined::Through(ratio, members) => {
            let behind = deflection * *ratio;
            for member in members {
                let moved = sheet.step(symbol("ψ", &member.place), "%", behind, words.behind);
                let carried = force * member.stiffness * *ratio / group.stiffness;
                let carried = sheet.step(symbol("φ", &member.place), "%", carried, words.reflected);
                inside(member, carried, moved, sheet, all, energies);
            }
            return;
        }
    };
    let mut parts = Vec::new();
    for member in members {
        let (force, deflection) = if in_series {
            let share = sheet.step(
                symbol("ψ", &member.place),
                "%",
                deflection * group.stiffness / member.stiffness,
                (words.in_series, RAO.at("§1.7")),
            );
            parts.push(share);
            (force, share)
        } else {
            let share = sheet.step(
                symbol("φ", &member.place),
                "%",
                force * member.stiffness / group.stiffness,
                (words.in_parallel, RAO.at("§1.7")),
            );
            parts.push(share);
            (share, deflection)
        };
        inside(member, force, deflection, sheet, all, energies);
    }
    if in_series {
        sheet.check(words.series_check, W::Num::sum(parts), deflection);
    } else {
        sheet.check(words.parallel_check, W::Num::sum(parts), force);
    }
}

/// Labels of the quantities of the members: forces and deflections, or torques and twists.
struct Words {
    in_series: &'static str,
    in_parallel: &'static str,
    behind: &'static str,
    reflected: &'static str,
    series_check: &'static str,
    parallel_check: &'static str,
    force_share: &'static str,
    deflection_share: &'static str,
    vibrating: [(&'static str, &'static str); 2],
    at_rest: [(&'static str, &'static str); 2],
}

impl Words {
    fn of(motion: SpringMotion) -> &'static Self {
        match motion {
            SpringMotion::Translation => &Words {
                in_series: "Fraction of the deflection: in series the force is the same",
                in_parallel: "Fraction of the force: in parallel the deflection is the same",
                behind: "Deflection beyond the lever, over that of the load",
                reflected: "Force beyond the lever, over that of the load",
                series_check: "the deflections of the members in series add up",
                parallel_check: "the forces of the members in parallel add up",
                force_share: "share of the force",
                deflection_share: "share of the deflection",
                vibrating: [("amplitude of the force", "N"), ("amplitude of the deflection", "mm")],
                at_rest: [("force", "N"), ("deflection", "mm")],
            },
            SpringMotion::Rotation => &Words {
                in_series: "Fraction of the twist: in series the torque is the same",
                in_parallel: "Fraction of the torque: in parallel the twist is the same",
                behind: "Angle beyond the gears, over that of the body",
                reflected: "Torque behind the gears, over that on the body",
                series_check: "the twists of the members in series add up",
                parallel_check: "the torques of the members in parallel add up",
                force_share: "share of the torque",
                deflection_share: "share of the twist",
                vibrating: [("amplitude of the torque", "N*m"), ("amplitude of the twist", "deg")],
                at_rest: [("torque", "N*m"), ("twist", "deg")],
            },
        }
    }
}

fn table(all: &[Share], motion: SpringMotion, stiffness: f64, loaded: Option<Loaded>) -> TableExhibit {
    let words = Words::of(motion);
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns = vec![
        column("spring", ""),
        column("kind", ""),
        column("stiffness", motion.unit()),
        column(words.force_share, "%"),
        column(words.deflection_share, "%"),
    ];
    let amplitude = loaded.map(|loaded| {
        let (headings, x) = match loaded {
            Loaded::Vibrating(x) => (words.vibrating, x),
            Loaded::AtRest(x) => (words.at_rest, x),
        };
        columns.extend(headings.map(|(heading, unit)| column(heading, unit)));
        (x, stiffness * x)
    });
    let row = |share: &Share| {
        let name = Text::new(printer::symbol(&share.symbol));
        let mut cells: Vec<Cell> = vec![
            name.into(),
            share.label.into(),
            share.stiffness.into(),
            share.force.into(),
            share.deflection.into(),
        ];
        if let Some((deflection, force)) = amplitude {
            cells.extend([Cell::Number(share.force * force), Cell::Number(share.deflection * deflection)]);
        }
        cells
    };
    TableExhibit {
        title: "Force in each spring".into(),
        columns,
        rows: all.iter().map(row).collect(),
        foot: Vec::new(),
    }
}
