//! Every published case of every analysis.

use dalembert_core::{cases, registry, Stop, printer, Locale};
use dalembert_plugins as _;

#[test]
fn show() {
    for entry in registry() {
        println!("== {}", entry.about.id);
        for case in cases::cases(entry).unwrap() {
            let record = case.record(entry).unwrap();
            let s = entry.solve(&record, &Stop::new()).unwrap();
            for locale in [Locale::english(), { let mut l = Locale::portuguese(); l.style.ascii = true; l }] {
            for step in &s.steps {
                let w = printer::step(&s, step, &locale);
                println!("{} [{}]\n   {} = {}\n      = {}\n      = {}", w.why, w.source, w.symbol, w.formula, w.substitution, w.result);
            }}
            for a in &s.answers { println!("{}: {}", a.label, a.shown(&Locale::english())); }
            println!("{:?} {:?} {:?}", s.checks, s.warnings, s.defects);
            for v in case.verify(entry).unwrap() { println!("{v:?}"); }
        }
    }
}
