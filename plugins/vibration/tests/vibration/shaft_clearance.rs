//! The permitted diameters of a shaft in its stator, against every speed tried by itself.

use std::f64::consts::TAU;

use dalembert_core::{Analysis, AnswerValue, FieldPath, Inputs, Lift, Sheet, Stop};
use dalembert_mechanics::{beam, sdof, section};
use dalembert_numerics::intervals::IntervalSet;
use dalembert_vibration::shafts_and_rotors::shaft_clearance::{
    ClearanceDamping, Mounting, PermittedQuantity, RoundShaft, ShaftClearance, SpeedRange,
};

const SPEEDS: [f64; 2] = [600.0 * TAU / 60.0, 6000.0 * TAU / 60.0];
const LENGTH: f64 = 2.0;
const YOUNG: f64 = 207e9;

fn turbine(damping: ClearanceDamping, unbalance: f64) -> ShaftClearance {
    ShaftClearance {
        mass: 250.0,
        clearance: 5e-3,
        damping,
        sought: PermittedQuantity::Diameter {
            unbalance,
            speeds: SpeedRange { lowest: SPEEDS[0], highest: SPEEDS[1], margin: None },
            shaft: RoundShaft { mounting: Mounting::Clamped, length: LENGTH, young: YOUNG },
            smallest_diameter: None,
            largest_diameter: None,
            diameter: None,
        },
    }
}

fn permitted_diameters(problem: &ShaftClearance) -> IntervalSet {
    let stop = Stop::new();
    let sheet = Sheet::new(&stop);
    let given = problem.given(Lift { sheet: &sheet, value: None, field_path: &FieldPath::TOP });
    problem.solve(&given, &sheet).unwrap();
    let solution = sheet.into_solution().unwrap();
    assert!(solution.checks.iter().all(|check| check.passed));
    match &solution.answer("diameters").unwrap().value {
        AnswerValue::Set(set, _) => set.clone(),
        AnswerValue::Number(..) | AnswerValue::List(_) => panic!("the diameters are a set"),
    }
}

/// The largest amplitude at any of many speeds of the range.
fn by_brute_force(problem: &ShaftClearance, unbalance: f64, diameter: f64) -> f64 {
    let k = beam::clamped_clamped_middle(YOUNG, section::round_second_moment(diameter), LENGTH);
    let c = match problem.damping {
        ClearanceDamping::Undamped => 0.0,
        ClearanceDamping::Ratio { ratio } => sdof::damping_from_ratio(ratio, k, problem.mass),
        ClearanceDamping::Coefficient { coefficient } => coefficient,
    };
    let amplitude = |n: u16| {
        let share = f64::from(n) / 4000.0;
        let speed = SPEEDS[0] + share * (SPEEDS[1] - SPEEDS[0]);
        sdof::unbalance_amplitude(unbalance, k, problem.mass, c, speed)
    };
    (0..=4000).map(amplitude).fold(0.0, f64::max)
}

#[test]
fn a_diameter_is_permitted_where_no_speed_reaches_the_clearance() {
    let dampings = [
        ClearanceDamping::Ratio { ratio: 0.03 },
        ClearanceDamping::Ratio { ratio: 0.2 },
        ClearanceDamping::Ratio { ratio: 0.5 },
        ClearanceDamping::Ratio { ratio: 1.2 },
        ClearanceDamping::Coefficient { coefficient: 3e3 },
        ClearanceDamping::Coefficient { coefficient: 3e4 },
        ClearanceDamping::Coefficient { coefficient: 3e5 },
    ];
    let mut seen = [0, 0];
    for damping in dampings {
        // Eccentricities of a fifth of the clearance, four fifths and twice.
        for unbalance in [0.25, 1.0, 2.5] {
            let problem = turbine(damping.clone(), unbalance);
            let set = permitted_diameters(&problem);
            for n in 0..60 {
                let diameter = 0.01 * 1.08f64.powi(n);
                let worst = by_brute_force(&problem, unbalance, diameter) / problem.clearance;
                // So near to the clearance the speeds tried are not dense enough to tell.
                if (worst - 1.0).abs() > 2e-3 {
                    assert_eq!(set.contains(diameter), worst < 1.0, "{problem:?}, d = {diameter}, {worst}");
                    seen[usize::from(worst < 1.0)] += 1;
                }
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
}
