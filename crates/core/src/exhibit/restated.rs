//! Plots, tables and drawings in a system of units.

use dalembert_units::UnitSystem;

use super::{Cell, Exhibit, Plot, Shape3, TableExhibit};
use crate::unit_system::of_text;

impl Exhibit {
    /// Shows every number in the unit of a system: axes, columns, and the words of drawings.
    pub(crate) fn restate(&mut self, system: UnitSystem) {
        match self {
            Exhibit::Plot(plot) => plot.restate(system),
            Exhibit::Table(table) => table.restate(system),
            Exhibit::Drawing(drawing) => {
                drawing.title.restate(system);
                drawing.shapes = drawing.shapes.restated(system);
            }
            Exhibit::Animation(animation) => {
                animation.title.restate(system);
                animation.frames = animation.frames.restated(system);
            }
            Exhibit::Scene(scene) => {
                scene.title.restate(system);
                for shape in scene.frames.iter_mut().flatten() {
                    if let Shape3::Label(_, words) = shape {
                        words.restate(system);
                    }
                }
            }
        }
    }
}

impl Plot {
    fn restate(&mut self, system: UnitSystem) {
        self.title.restate(system);
        for axis in [&mut self.x, &mut self.y] {
            axis.unit = of_text(axis.unit, system);
            axis.label.restate(system);
        }
        let series = self.series.iter_mut().map(|series| &mut series.label);
        let marks = self.marks.iter_mut().map(|mark| &mut mark.label);
        let bands = self.bands.iter_mut().map(|band| &mut band.label);
        let levels = self.levels.iter_mut().map(|level| &mut level.label);
        series.chain(marks).chain(bands).chain(levels).for_each(|label| label.restate(system));
    }
}

impl TableExhibit {
    fn restate(&mut self, system: UnitSystem) {
        self.title.restate(system);
        for column in &mut self.columns {
            column.unit = of_text(column.unit, system);
            column.heading.restate(system);
        }
        for cell in self.rows.iter_mut().flatten().chain(&mut self.foot) {
            if let Cell::Text(text) = cell {
                text.restate(system);
            }
        }
    }
}
