//! Coverage of answers by the checks of a solution.

use dalembert_core::{
    About, Analysis, Entry, Inputs, Refusal, Sides, Stop, Worksheet,
    coverage::{self, Coverage, CoverageStatus, Reason},
};
use dalembert_numerics::Real;

/// A disc that turns.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Disc {
    /// Moment of inertia.
    #[input("J", "kg*m^2", positive)]
    inertia: f64,
    /// Angular speed.
    #[input("ω", "rad/s", positive)]
    speed: f64,
}

impl Analysis for Disc {
    const ABOUT: About = About {
        id: "test/disc",
        title: "Disc",
        topic: "Test",
        summary: "A disc.",
        main: &[],
        keywords: "",
        sources: &[],
        cases: r#"
            [uncovered]
            "definition" = ["power"]
            "count" = ["energy"]
            [[case]]
            name = "Disc"
            source = "closed form"
            truth = "closed form"
            inputs = { inertia = "2 kg*m^2", speed = "3 rad/s" }
            expect = { energy = "9.000 J" }
        "#,
    };

    fn solve<W: Worksheet>(&self, given: &Self::Given<W>, sheet: W) -> Result<(), Refusal> {
        let momentum = sheet.step("H", "kg*m^2/s", given.inertia * given.speed, "why");
        let energy = sheet.step("T", "J", momentum * given.speed / 2.0, "why");
        let power = sheet.step("P", "W", given.inertia * given.speed.powi(3), "why");
        let own = sheet.step("L", "kg*m^2/s", given.speed * given.inertia, "why");
        let plain = sheet.numerical("U", "J", momentum.value() * momentum.value() / 4.0, "how");
        let twice = sheet.step("D", "J", energy * 2.0, "why");
        let same = sheet.step("S", "rad/s", given.speed, "why");
        // Both sides rest on the momentum, one of them outside of the trace; it does not cancel.
        sheet.check("energy", energy, momentum.powi(2) / (given.inertia * 2.0));
        sheet.check_residual("plain", W::Num::from(plain.value() - 9.0), 9.0, 0.0);
        sheet.check("own", own, given.inertia * given.speed);
        sheet.check("power cancels", power * 2.0 / power, W::Num::from(2.0));
        sheet.answer("momentum", "Momentum", momentum);
        sheet.answer("energy", "Energy", energy);
        sheet.answer("power", "Power", power);
        sheet.answer("own", "Own", own);
        sheet.answer("plain", "Plain", plain);
        sheet.answer("twice", "Twice", twice);
        sheet.answer("same", "Same", same);
        sheet.answer_list("list", "List", "m", &[1.0, 2.0]);
        Ok(())
    }
}

static DISC: Entry = Entry::of::<Disc>();

#[test]
fn an_answer_is_covered_when_a_check_notices_that_it_is_wrong() {
    let all = coverage::coverage(&DISC, &Stop::new()).unwrap();
    let of = |name: &str| all.iter().find(|one| one.answer == name).unwrap();
    let by = |what: &'static str| CoverageStatus::Covered(what.into());
    assert_eq!(of("momentum").status, by("energy"));
    assert_eq!(of("energy").status, by("energy"));
    assert_eq!(of("plain").status, by("plain"));
    assert_eq!(of("twice").status, CoverageStatus::Form);
    assert_eq!(of("same").status, CoverageStatus::Input);
    // It cancels; the other check has the same tree on both sides; a list has no steps.
    for name in ["power", "own", "list"] {
        assert_eq!(of(name).status, CoverageStatus::Uncovered, "{name}");
    }
    assert_eq!(of("power").reason, Some(Reason::Definition));
    assert_eq!(of("own").reason, None);
    assert_eq!(all.iter().filter(|one| one.is_stale()).map(|one| one.answer).collect::<Vec<_>>(), ["energy"]);
    assert_eq!(all.iter().map(|Coverage { answer, .. }| *answer).collect::<Vec<_>>().len(), 8);
}

#[test]
fn a_check_of_the_same_tree_is_named() {
    let case = &dalembert_core::cases::cases(&DISC).unwrap()[0];
    let solution = DISC.solve(&case.record(&DISC).unwrap(), &Stop::new()).unwrap();
    assert!(solution.checks.iter().all(|check| check.passed), "{:?}", solution.checks);
    let same: Vec<String> =
        coverage::same_trees(&solution).iter().map(|check| check.what.english()).collect();
    assert_eq!(same, ["own"]);
    let sides: Vec<Sides> = solution.checks.iter().map(|check| check.sides).collect();
    assert!(
        matches!(sides[..], [Sides::Both(..), Sides::Plain, Sides::Both(..), Sides::One(_)]),
        "{sides:?}"
    );
}
