//! The program with an analysis that misbehaves in every way that a plugin can, and with an id that is taken: the tests of
//! plugins run it.

use std::{
    hint::black_box,
    process::{ExitCode, exit},
};

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Scale, Series, Worksheet, register,
};
use dalembert_plugins as _;

/// An analysis that does what its input says.
#[derive(Clone, Debug, Inputs)]
pub struct Misbehaving {
    /// Misdeed, by number.
    #[input("n", "1", positive)]
    pub deed: f64,
}

register!(Misbehaving);

impl Analysis for Misbehaving {
    const ABOUT: About = About {
        id: "misbehaving/plugin",
        title: "Misbehaving plugin",
        topic: "Faults",
        summary: "Does what no analysis should.",
        main: &["answer"],
        keywords: "fault",
        sources: &[],
        cases: "[[case]]\nname = \"Sound\"\nsource = \"ours\"\n[case.inputs]\ndeed = \"9\"\n[case.expect]\nanswer = \"9\"\n",
    };

    fn solve<W: Worksheet>(&self, given: &MisbehavingGiven<W>, sheet: W) -> Result<(), Refusal> {
        match self.deed {
            1.0 => panic!("row {} is empty", 3),
            2.0 => loop {
                black_box(());
            },
            3.0 => _ = sheet.step("y", "1", given.deed * f64::NAN, "A number that is none"),
            // A length is no mass.
            4.0 => _ = sheet.step("L", "kg", given.deed, "A mass that is a number"),
            5.0 => exit(7),
            6.0 => {
                let mut hoard: Vec<Vec<u8>> = Vec::new();
                loop {
                    hoard.push(black_box(vec![1; 1 << 26]));
                }
            }
            7.0 => sheet.show(|| {
                let axis = || Axis { label: "Number".into(), unit: "1", scale: Scale::Linear };
                let points = (0..10_000_000).map(|n| (f64::from(n), f64::from(n % 7))).collect();
                let series = Series {
                    label: "Points".into(),
                    points,
                    joined: true,
                    of: None,
                    with: Vec::new(),
                    at: Vec::new(),
                };
                Exhibit::Plot(Plot {
                    title: "Many points".into(),
                    x: axis(),
                    y: axis(),
                    series: vec![series],
                    marks: Vec::new(),
                    bands: Vec::new(),
                    levels: Vec::new(),
                    over: None,
                    equal: false,
                })
            }),
            8.0 => _ = sheet.step("y", "1", given.deed / 0.0, "A number beyond all"),
            _ => {}
        }
        let answer = sheet.step("x", "1", given.deed * 1.0, "The number itself");
        sheet.answer("answer", "Answer", answer);
        Ok(())
    }
}

/// An analysis with the id of another.
#[derive(Clone, Debug, Inputs)]
pub struct Impostor {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
}

register!(Impostor);

impl Analysis for Impostor {
    const ABOUT: About = About {
        id: "vibration/gun-recoil",
        title: "Impostor",
        topic: "Faults",
        summary: "Has the id of another analysis.",
        main: &["mass"],
        keywords: "fault",
        sources: &[],
        cases: "",
    };

    fn solve<W: Worksheet>(&self, given: &ImpostorGiven<W>, sheet: W) -> Result<(), Refusal> {
        sheet.answer("mass", "Mass", given.mass);
        Ok(())
    }
}

fn main() -> ExitCode {
    dalembert::main()
}
