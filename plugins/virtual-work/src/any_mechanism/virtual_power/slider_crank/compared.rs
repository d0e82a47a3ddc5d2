//! Numbers of the given motion beside those that the loop demands.

use dalembert_core::{
    TableExhibit, Text,
    exhibit::{Cell, Column},
};
use nalgebra::Vector3;

/// The given motion may be off by this share of itself before it is called contradictory: numbers are printed with
/// three digits.
const CONSISTENT: f64 = 0.01;

/// A number of the given motion beside the one that the loop demands, both in SI.
pub(super) struct Compared {
    pub(super) what: &'static str,
    /// The unit it is shown in.
    pub(super) unit: &'static str,
    /// For a vector, its magnitude; for one along x, its component.
    pub(super) given: f64,
    /// Likewise.
    pub(super) required: f64,
    /// Difference of the two; for a vector, the magnitude of the difference.
    pub(super) apart: f64,
    /// Natural magnitude of this quantity in this mechanism: a difference far below it is rounding.
    pub(super) natural: f64,
}

impl Compared {
    pub(super) fn scalar(
        what: &'static str,
        unit: &'static str,
        given: f64,
        required: f64,
        natural: f64,
    ) -> Self {
        Self { what, unit, given, required, apart: (given - required).abs(), natural }
    }

    /// A vector along x, by its component; what is given across x counts as a difference.
    pub(super) fn along_x(
        what: &'static str,
        unit: &'static str,
        given: Vector3<f64>,
        required: f64,
        natural: f64,
    ) -> Self {
        let apart = (given - Vector3::x() * required).norm();
        Self { what, unit, given: given.x, required, apart, natural }
    }

    /// Two vectors, by their magnitudes and the length of their difference.
    pub(super) fn vector(
        what: &'static str,
        unit: &'static str,
        given: Vector3<f64>,
        required: Vector3<f64>,
        natural: f64,
    ) -> Self {
        Self {
            what,
            unit,
            given: given.norm(),
            required: required.norm(),
            apart: (given - required).norm(),
            natural,
        }
    }

    /// The difference over the larger of the two; zero where it is rounding alone.
    fn share(&self) -> f64 {
        let larger = self.given.abs().max(self.required.abs());
        if self.apart <= 1e-9 * larger { 0.0 } else { self.apart / larger }
    }

    pub(super) fn contradicts(&self) -> bool {
        self.share() > CONSISTENT && self.apart > 1e-6 * self.natural
    }

    pub(super) fn warning(&self) -> Text {
        Text::new("{what}: given {given}, loop closure requires {demanded} (difference {apart}, {share} of the larger)")
            .with_text("what", self.what)
            .with_quantity("given", self.given, self.unit)
            .with_quantity("demanded", self.required, self.unit)
            .with_quantity("apart", self.apart, self.unit)
            .with_quantity("share", self.share(), "%")
    }
}

/// All of them, as a table.
pub(super) fn table(compared: &[Compared]) -> TableExhibit {
    let quantity = |si: f64, unit: &'static str| Cell::Text(Text::new("{x}").with_quantity("x", si, unit));
    let row = |it: &Compared| {
        vec![
            Cell::Text(it.what.into()),
            quantity(it.given, it.unit),
            quantity(it.required, it.unit),
            quantity(if it.share() == 0.0 { 0.0 } else { it.apart }, it.unit),
            Cell::Number(it.share()),
        ]
    };
    let words = |heading: &'static str| Column { heading: heading.into(), unit: "" };
    TableExhibit {
        title: "Given motion and motion required by loop closure".into(),
        columns: vec![
            words("Quantity"),
            words("Given"),
            words("Required"),
            words("Difference"),
            Column { heading: "Fraction of the larger value".into(), unit: "%" },
        ],
        rows: compared.iter().map(row).collect(),
        foot: Vec::new(),
    }
}
