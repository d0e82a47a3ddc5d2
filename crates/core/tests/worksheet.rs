//! Text of a worked solution: signs, brackets, fractions, powers, vectors, sums, dimensions.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use dalembert_core::{
    Field, FieldPath, Locale, Measure, Number, Refusal, Shape, Sheet, Solution, Stop, Term, VectorTerm,
    Worksheet,
    mutation::{Mutant, Mutation},
    printer,
    worksheet::InputNumber,
};
use dalembert_numerics::{Real, Vector};
use nalgebra::Vector3;

/// Works on a sheet with `a = 3 m`, `b = −2 m`, `t = 4 s`, `θ = 30°` and two vectors.
struct Bench<'s> {
    sheet: &'s Sheet<'s>,
    a: Term<'s>,
    b: Term<'s>,
    t: Term<'s>,
    angle: Term<'s>,
    force: VectorTerm<'s>,
    arm: VectorTerm<'s>,
}

/// An input of that symbol in that unit.
fn input(symbol: &'static str, unit: &'static str) -> InputNumber<'static> {
    let measure = Measure::in_unit(unit);
    let field = Field {
        name: symbol,
        label: "",
        help: "",
        symbol,
        default: None,
        default_before: None,
        kept_in: None,
        former: &[],
        shape: Shape::Quantity(measure),
    };
    InputNumber { field: Box::leak(Box::new(field)), at: None, value: None, field_path: &FieldPath::TOP }
}

fn worked(work: impl for<'s> FnOnce(&Bench<'s>)) -> Solution {
    worked_on(Sheet::new(&Stop::new()), work)
}

fn worked_on<'a>(sheet: Sheet<'a>, work: impl for<'s> FnOnce(&Bench<'s>)) -> Solution {
    let given = |symbol, unit, si| (&sheet).given(input(symbol, unit), si);
    let vector = |symbol, unit, si| (&sheet).given_vector(input(symbol, unit), si);
    work(&Bench {
        sheet: &sheet,
        a: given("a", "m", 3.0),
        b: given("b", "m", -2.0),
        t: given("t", "s", 4.0),
        angle: given("θ", "deg", 30f64.to_radians()),
        force: vector("F", "N", Vector3::new(5.0, 0.0, -1.0)),
        arm: vector("r", "m", Vector3::new(0.0, 2.0, 0.0)),
    });
    sheet.into_solution().unwrap()
}

/// `formula | substitution | result` of the last step.
fn written(work: impl for<'s> FnOnce(&Bench<'s>)) -> String {
    let solution = worked(work);
    assert_eq!(solution.defects, Vec::<String>::new());
    let step = printer::step(&solution, solution.steps.last().unwrap(), &Locale::english());
    format!("{} | {} | {}", step.formula, step.substitution, step.result)
}

/// The formula of a length.
fn length(formula: impl for<'s> Fn(&Bench<'s>) -> Term<'s>) -> String {
    let formula = written(|bench| {
        bench.sheet.step("x", "m", formula(bench), "why");
    });
    formula.split(" | ").next().unwrap().to_owned()
}

#[test]
fn signs_and_brackets_are_those_of_a_textbook() {
    assert_eq!(length(|s| s.a + s.b), "a + b");
    assert_eq!(length(|s| s.a - s.b), "a − b");
    assert_eq!(length(|s| -s.a), "−a");
    assert_eq!(length(|s| -(-s.a)), "a");
    assert_eq!(length(|s| s.a - -s.b), "a + b");
    assert_eq!(length(|s| s.a - (s.b - s.a)), "a − b + a");
    assert_eq!(length(|s| -(s.a + s.b)), "−a − b");
    assert_eq!(length(|s| s.a * -2.0), "−2 a");
    assert_eq!(length(|s| s.a * 2.0 + s.b * 3.0), "2 a + 3 b");
    assert_eq!(length(|s| (s.a + s.b) * 2.0), "2 (a + b)");
    assert_eq!(length(|s| s.a * s.b / s.a), "a b / a");
    assert_eq!(length(|s| s.a / (s.b / s.a)), "a² / b");
    assert_eq!(length(|s| s.a * std::f64::consts::FRAC_PI_4 / s.b * s.a), "π a² / (4 b)");
    assert_eq!(length(|s| s.a + s.b * 0.0), "a");
    assert_eq!(length(|s| s.a / (2.0 * std::f64::consts::PI)), "a / (2π)");
    assert_eq!(length(|s| s.a * 4.0 / (s.b * 2.0) * s.b * 3.0), "12 a b / (2 b)");
    assert_eq!(length(|s| s.a.powi(2) / (s.b * 2.0)), "a² / (2 b)");
    assert_eq!(length(|s| s.a.powi(3) / (s.a + s.b).powi(2)), "a³ / (a + b)²");
    assert_eq!(length(|s| (s.a * s.b).abs().sqrt()), "√|a b|");
    assert_eq!(length(|s| (s.a.powi(2) + s.b.powi(2)).sqrt()), "√(a² + b²)");
    assert_eq!(length(|s| s.a * s.angle.sin()), "a sin θ");
    assert_eq!(length(|s| s.a * (s.angle * 2.0).cos()), "a cos(2 θ)");
    assert_eq!(length(|s| s.a * s.a.powi(-1) * s.b), "a a⁻¹ b");
    assert_eq!(length(|s| Term::from(1.0) * s.a), "a");
    assert_eq!(length(|s| s.a.powi(4).root(4)), "⁴√(a⁴)");
    assert_eq!(length(|s| s.a * std::f64::consts::PI), "π a");
    assert_eq!(length(|s| (s.a / s.b).powi(2) * s.a), "(a / b)² a");
}

#[test]
fn values_stand_in_the_units_they_were_typed_in() {
    assert_eq!(
        written(|s| {
            s.sheet.step("v", "m/s", (s.a - s.b.powi(2) / s.a) / s.t, "why");
        }),
        "(a − b² / a) / t | (3 m − (−2 m)² / 3 m) / 4 s | 0.41667 m/s"
    );
    assert_eq!(
        written(|s| {
            s.sheet.step("x", "mm", s.b * 3.0 * s.angle.sin(), "why");
        }),
        "3 b sin θ | 3 × (−2 m) × sin(30°) | −3000 mm"
    );
}

#[test]
fn vectors_are_written_as_vectors() {
    assert_eq!(
        written(|s| {
            s.sheet.step_vector("M", "N*m", s.arm.cross(s.force), "why");
        }),
        "r × F | (2 j) m × (5 i − 1 k) N | (−2 i − 10 k) N·m"
    );
    assert_eq!(
        written(|s| {
            s.sheet.step("W", "J", s.force.dot(s.arm + s.arm), "why");
        }),
        "F · (r + r) | (5 i − 1 k) N · ((2 j) m + (2 j) m) | 0 J"
    );
    assert_eq!(
        written(|s| {
            s.sheet.step_vector("p", "m", VectorTerm::from_components(s.a, Term::from(0.0), -s.b), "why");
        }),
        "a i − b k | 3 m i − (−2 m) k | (3 i + 2 k) m"
    );
}

#[test]
fn a_long_sum_is_written_with_sigma_and_its_terms() {
    let solution = worked(|s| {
        let x = |n| s.sheet.step(("x", n), "m", s.a * n as f64, "why");
        let terms: Vec<Term<'_>> = (1..=5).map(x).map(|x| x * 2.0).collect();
        s.sheet.step("S", "m", Term::sum(terms), "why");
    });
    let step = printer::step(&solution, solution.steps.last().unwrap(), &Locale::english());
    assert_eq!(step.formula, "Σ 2 xᵢ");
    assert_eq!(step.result, "90 m");
    let terms: Vec<_> = step.terms.iter().map(|(term, value)| format!("{term} = {value}")).collect();
    assert_eq!(terms, ["2 x₁ = 6 m", "2 x₂ = 12 m", "2 x₃ = 18 m", "2 x₄ = 24 m", "2 x₅ = 30 m"]);
}

#[test]
fn dimensions_are_followed() {
    fn defects(step: impl for<'s> Fn(&Bench<'s>) -> (&'static str, &'static str, Term<'s>)) -> String {
        let work = |bench: &Bench<'_>| {
            let (symbol, unit, value) = step(bench);
            bench.sheet.step(symbol, unit, value, "why");
        };
        worked(work).defects.join("; ")
    }
    assert_eq!(defects(|s| ("x", "m", s.a / s.t)), "x = a / t is in m·s⁻¹, not in m");
    assert_eq!(defects(|s| ("x", "m", s.a + s.t)), "a is in m, t is in s");
    assert!(defects(|s| ("x", "1", s.a.sin())).contains("sin of a number in m"));
    assert!(defects(|s| ("x", "m", s.a.sqrt())).contains("root of order 2"));
    // The angle is a dimension of what is typed, not of what is computed: v = ω r.
    assert_eq!(defects(|s| ("v", "m/s", s.a * s.angle / s.t)), "");
    // Zero has every dimension.
    assert_eq!(defects(|s| ("x", "m", s.a + 0.0)), "");
}

#[test]
fn a_number_beyond_the_finite_is_a_refusal() {
    let stop = Stop::new();
    let sheet = Sheet::new(&stop);
    let a = (&sheet).given(input("a", "m"), 1e200);
    (&sheet).step("x", "m^2", a.powi(2), "why");
    let Err(Refusal::NoAnswer(why)) = sheet.into_solution() else { panic!("infinity is no answer") };
    assert_eq!(why.english(), "these inputs lead to a number that cannot be represented: x");
}

#[test]
fn a_negative_value_has_brackets_only_where_something_stands_before_it() {
    assert_eq!(
        written(|s| {
            s.sheet.step("φ", "deg", s.b.atan2(s.a - s.b), "why");
        }),
        "atan2(b, a − b) | atan2(−2 m, 3 m − (−2 m)) | −21.801°"
    );
}

#[test]
fn one_of_several_answers_is_named_by_its_place() {
    let solution = worked(|s| {
        let (first, second) =
            (s.sheet.step(("x", 1), "m", s.a, "why"), s.sheet.step(("x", 2), "m", s.b, "why"));
        s.sheet.answer(("position", 1), "Position", first);
        s.sheet.answer(("position", 2), "Position", second);
        s.sheet.answer_list(("shape", 2), "Shape", "mm", &[0.001, -0.0005, 1e-20]);
    });
    assert_eq!(solution.answer("position[2]").and_then(dalembert_core::Answer::si), Some(-2.0));
    for other in ["position", "position[3]", "position[2][1]", "positions[1]", "position[02]"] {
        assert!(solution.answer(other).is_none(), "{other}");
    }
    let shape = solution.answer("shape[2]").unwrap();
    assert_eq!(shape.label(&Locale::english()), "Shape 2");
    assert_eq!(shape.shown(&Locale::english()), "(1; −0.5; 0) mm");
}

#[test]
fn a_list_with_a_number_beyond_the_finite_is_a_refusal() {
    let stop = Stop::new();
    let sheet = Sheet::new(&stop);
    (&sheet).answer_list("shape", "Shape", "1", &[1.0, f64::INFINITY]);
    let Err(Refusal::NoAnswer(why)) = sheet.into_solution() else { panic!("an infinite number was shown") };
    assert!(why.english().contains("shape"), "{}", why.english());
}

#[test]
fn the_worst_of_several_residuals_speaks_for_all() {
    let passes = |residuals: [f64; 3]| {
        let solution = worked(|bench| bench.sheet.check_zeros("they vanish", residuals, 1.0));
        assert_eq!(solution.checks.len(), 1);
        solution.checks[0].passed
    };
    assert!(passes([1e-12, -2e-12, 0.0]));
    for one in [1e-3, -1e-3, f64::NAN, f64::INFINITY] {
        assert!(!passes([one, 0.0, 0.0]) && !passes([0.0, one, 1e-12]) && !passes([0.0, 0.0, one]), "{one}");
    }
}

/// A second method in which nothing was added up gives zero, and agrees with zero alone.
#[test]
fn beside_a_scale_of_zero_only_zero_agrees() {
    let passes = |right: f64, scale: f64| {
        let solution = worked(|bench| {
            let left = bench.sheet.step("x", "1", bench.a / bench.a * 0.3, "why");
            bench.sheet.check_sum("two ways", left, right.into(), scale);
        });
        solution.checks[0].passed
    };
    assert!(passes(0.3, 0.3) && passes(0.3, 0.0));
    assert!(
        !passes(0.0, 0.0) && !passes(0.301, 0.0) && !passes(0.0, f64::INFINITY) && !passes(0.0, f64::NAN)
    );
}

/// Two methods agree as nearly as their condition lets the last places tell, and no nearer.
#[test]
fn the_limit_of_a_check_comes_from_its_condition() {
    // 1 − cos x of a small x in both ways, beside the exact value: six digits are lost at 10⁻³, and twelve at 10⁻⁶.
    let versine = |x: f64, times: f64| {
        worked(|bench| {
            let x = bench.sheet.step("x", "1", bench.a * x / bench.a, "why");
            let exact = (x / 2.0).sin().powi(2) * 2.0 * times;
            bench.sheet.check("versine", -x.cos() + 1.0, exact);
        })
        .checks
        .remove(0)
    };
    for (x, lost) in [(0.5, 1e-15), (1e-3, 1e-9), (1e-6, 1e-3)] {
        let check = versine(x, 1.0);
        assert!(check.passed && check.limit <= 100.0 * f64::max(lost, 2e-11), "{x}: {check:?}");
        assert!(!versine(x, 1.0 + 100.0 * check.limit).passed, "{x}");
    }
    assert_eq!(versine(0.5, 1.0).limit, 1e-9);
    assert!(!versine(0.5, 1.0 + 1e-6).passed);
    // A number from elsewhere knows no more of the inputs than the other way does.
    let beside = |apart: f64| {
        worked(|bench| {
            let difference = bench.a * (1.0 + 1e-9) - bench.a;
            let other = Term::from(3e-9 * (1.0 + apart));
            bench.sheet.check("difference", difference, other);
        })
        .checks
        .remove(0)
        .passed
    };
    assert!(beside(1e-7) && !beside(1e-4));
    let stated = |error: f64| {
        worked(|bench| {
            let found = bench.sheet.numerical_within("x", "m", 1.0 + 1e-7, error, "how");
            bench.sheet.check("found", found, bench.a / bench.a);
        })
        .checks
        .remove(0)
        .passed
    };
    assert!(!stated(0.0) && stated(1e-7));
}

/// The result of `y = formula` and that of `2 y`, the operation of the formula or the result made wrongly.
fn mutated(mutation: Mutation, formula: impl for<'s> Fn(&Bench<'s>) -> Term<'s>) -> [f64; 2] {
    let work = |bench: &Bench<'_>| {
        let y = bench.sheet.step("y", "1", formula(bench), "why");
        bench.sheet.step("z", "1", y * 2.0, "why");
    };
    let right = worked(work);
    let step = &right.steps[0];
    let is_of_result =
        matches!(mutation, Mutation::Perturbed | Mutation::Negated | Mutation::Doubled | Mutation::FullTurn);
    let at = if is_of_result { step.result } else { step.formula.unwrap() };
    let mutant = Mutant { at, mutation };
    let stop = Stop::new();
    let wrong = worked_on(Sheet::mutated(&stop, mutant), work);
    // The number that is stated beforehand is what comes out.
    assert_eq!(mutant.number(&right.trace), Some(wrong.trace.node(at).number));
    [0, 1].map(|step| match wrong.trace.node(wrong.steps[step].result).number {
        Number::Scalar(x) => x,
        Number::Vector(_) => unreachable!("y is a number"),
    })
}

#[test]
fn a_number_made_wrongly_is_carried_on() {
    let near = |[y, z]: [f64; 2], known: f64| {
        assert!((y - known).abs() < 1e-12 && (z - 2.0 * known).abs() < 1e-12, "{y}, {z} and not {known}");
    };
    near(mutated(Mutation::Perturbed, |s| s.a / s.b), -1.5 * 1.000_001);
    near(mutated(Mutation::Negated, |s| s.a / s.b), 1.5);
    near(mutated(Mutation::Doubled, |s| s.a / s.b), -3.0);
    near(mutated(Mutation::FullTurn, |s| s.a / s.b), -3.0 * std::f64::consts::PI);
    near(mutated(Mutation::Transposed, |s| s.a / s.b), -2.0 / 3.0);
    near(mutated(Mutation::Sign, |s| s.a / s.b - s.b / s.a), -1.5 - 2.0 / 3.0);
    near(mutated(Mutation::Sign, |s| s.a / s.b + s.b / s.a), -1.5 + 2.0 / 3.0);
    near(mutated(Mutation::Sign, |s| -(s.a / s.b)), -1.5);
    near(mutated(Mutation::Sign, |s| Real::sum([s.a / s.b, s.b / s.a, s.a / s.b])), -2.0 / 3.0);
    near(mutated(Mutation::Cofunction, |s| s.angle.sin()), 0.75_f64.sqrt());
    near(mutated(Mutation::Cofunction, |s| s.angle.cos()), 0.5);
    near(mutated(Mutation::Cofunction, |s| s.angle.tan()), 3_f64.sqrt());
    near(mutated(Mutation::Degrees, |s| s.angle.sin()), 30_f64.sin());
    near(mutated(Mutation::Degrees, |s| Real::atan2(s.b, s.a)), (-2_f64).atan2(3.0).to_degrees());
    near(mutated(Mutation::Transposed, |s| Real::atan2(s.b, s.a)), 3_f64.atan2(-2.0));
}

#[test]
fn a_mutation_of_another_operation_is_none() {
    let solution = worked(|bench| {
        bench.sheet.step("y", "m", bench.a + bench.b, "why");
    });
    let at = solution.steps[0].formula.unwrap();
    let none = |mutation| Mutant { at, mutation }.number(&solution.trace).is_none();
    assert!(!none(Mutation::Sign));
    let others = Mutation::ALL.into_iter().filter(|mutation| *mutation != Mutation::Sign);
    assert_eq!(others.clone().count(), 6);
    assert!(others.into_iter().all(none));
}
