//! What each member of a network carries and how much it gives.

use dalembert_core::{Cell, Column, Exhibit, Symbol, TableExhibit, Text, Worksheet, printer};
use dalembert_mechanics::Real;

use super::{Element, Joined, symbol};
use crate::sources::RAO;

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
/// `deflection` is the amplitude of the whole, m, where it is known: the table then has forces and deflections too.
pub(crate) fn shares<W: Worksheet>(whole: &Element<W::Num>, sheet: W, deflection: Option<f64>) {
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
    sheet.show(|| Exhibit::Table(table(&all, deflection.map(|x| (x, stiffness * x)))));
}

fn inside<W: Worksheet>(
    group: &Element<W::Num>,
    force: W::Num,
    deflection: W::Num,
    sheet: W,
    all: &mut Vec<Share>,
    energies: &mut Vec<W::Num>,
) {
    let (members, in_series) = match &group.joined {
        Joined::Alone => {
            energies.push(group.stiffness * deflection.powi(2));
            all.push(Share {
                symbol: symbol("k", &group.place),
                label: group.label,
                stiffness: group.stiffness.value(),
                force: force.value(),
                deflection: deflection.value(),
            });
            return;
        }
        Joined::Series(members) => (members, true),
        Joined::Parallel(members) => (members, false),
    };
    let mut parts = Vec::new();
    for member in members {
        let (force, deflection) = if in_series {
            let share = sheet.step(
                symbol("ψ", &member.place),
                "%",
                deflection * group.stiffness / member.stiffness,
                ("Share of the deflection: in series the force is the same", RAO.at("§1.7")),
            );
            parts.push(share);
            (force, share)
        } else {
            let share = sheet.step(
                symbol("φ", &member.place),
                "%",
                force * member.stiffness / group.stiffness,
                ("Share of the force: in parallel the deflection is the same", RAO.at("§1.7")),
            );
            parts.push(share);
            (share, deflection)
        };
        inside(member, force, deflection, sheet, all, energies);
    }
    if in_series {
        sheet.check("the deflections of the members in series add up", W::Num::sum(parts), deflection);
    } else {
        sheet.check("the forces of the members in parallel add up", W::Num::sum(parts), force);
    }
}

fn table(all: &[Share], amplitude: Option<(f64, f64)>) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns = vec![
        column("spring", ""),
        column("kind", ""),
        column("stiffness", "kN/m"),
        column("share of the force", "%"),
        column("share of the deflection", "%"),
    ];
    if amplitude.is_some() {
        columns.extend([column("amplitude of the force", "N"), column("amplitude of the deflection", "mm")]);
    }
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
        title: "What each spring carries".into(),
        columns,
        rows: all.iter().map(row).collect(),
        foot: Vec::new(),
    }
}
