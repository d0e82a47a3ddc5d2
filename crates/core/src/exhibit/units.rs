//! Plots, tables and drawings in a system of units.

use dalembert_units::UnitSystem;

use super::{Cell, Exhibit, Plot, Shape3, TableExhibit};
use crate::unit_system::of_text;

impl Exhibit {
    /// Shows every number in the unit of a system: axes, columns, and the words of drawings.
    pub(crate) fn show_in(&mut self, system: UnitSystem) {
        match self {
            Exhibit::Plot(plot) => plot.show_in(system),
            Exhibit::Table(table) => table.show_in(system),
            Exhibit::Drawing(drawing) => {
                drawing.title.show_in(system);
                drawing.shapes = drawing.shapes.shown_in(system);
            }
            Exhibit::Animation(animation) => {
                animation.title.show_in(system);
                animation.frames = animation.frames.shown_in(system);
            }
            Exhibit::Scene(scene) => {
                scene.title.show_in(system);
                for shape in scene.frames.iter_mut().flatten() {
                    if let Shape3::Label(_, words) = shape {
                        words.show_in(system);
                    }
                }
            }
        }
    }
}

impl Plot {
    fn show_in(&mut self, system: UnitSystem) {
        self.title.show_in(system);
        for axis in [&mut self.x, &mut self.y] {
            axis.unit = of_text(axis.unit, system);
            axis.label.show_in(system);
        }
        let series = self.series.iter_mut().map(|series| &mut series.label);
        let marks = self.marks.iter_mut().map(|mark| &mut mark.label);
        let bands = self.bands.iter_mut().map(|band| &mut band.label);
        let levels = self.levels.iter_mut().map(|level| &mut level.label);
        series.chain(marks).chain(bands).chain(levels).for_each(|label| label.show_in(system));
    }
}

impl TableExhibit {
    fn show_in(&mut self, system: UnitSystem) {
        self.title.show_in(system);
        for column in &mut self.columns {
            column.unit = of_text(column.unit, system);
            column.heading.show_in(system);
        }
        for cell in self.rows.iter_mut().flatten().chain(&mut self.foot) {
            if let Cell::Text(text) = cell {
                text.show_in(system);
            }
        }
    }
}
