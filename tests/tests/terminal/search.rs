//! Search in the list of analyses, by the words that textbooks use: one for the workbench and the command line.

use dalembert_core::{
    Entry, cases, registry,
    search::{self, Index},
};
use dalembert_plugins as _;
use dalembert_tests::person::Person;
use dalembert_tui::picker::Row;

/// Words, and an analysis that stands among the first three.
const WORDS: [(&str, &str); 60] = [
    ("twin", "balancing/reciprocating"),
    ("V-twin", "balancing/reciprocating"),
    ("rotary engine", "virtual-work/oscillating-cylinder"),
    ("irodov", "rigid-body/gyroscopic-couple"),
    ("khurmi", "virtual-work/engine"),
    ("restitution", "rigid-body/impulse"),
    ("ball joint", "rigid-body/reactions"),
    ("logarithmic decrement", "vibration/logarithmic-decrement"),
    ("decremento logarítmico", "vibration/logarithmic-decrement"),
    ("tuned mass damper", "vibration/damped-absorber"),
    ("absorvedor de vibrações", "vibration/vibration-absorber"),
    ("half-power bandwidth", "vibration/frequency-response-identification"),
    ("accelerometer", "vibration/vibration-instrument"),
    ("acelerômetro", "vibration/vibration-instrument"),
    ("critical speed", "vibration/whirling-shaft"),
    ("velocidade crítica", "vibration/whirling-shaft"),
    ("Jeffcott rotor", "vibration/whirling-shaft"),
    ("Campbell diagram", "vibration/rotor-dynamics"),
    ("transmissibility", "vibration/vibration-isolation"),
    ("transmissibilidade", "vibration/base-excitation"),
    ("Holzer", "vibration/torsional-train"),
    ("double pendulum", "vibration/double-pendulum"),
    ("pêndulo duplo", "vibration/double-pendulum"),
    ("compound pendulum", "vibration/swing-test"),
    ("bifilar", "vibration/swing-test"),
    ("Coulomb friction", "vibration/coulomb-damping"),
    ("atrito seco", "vibration/coulomb-damping"),
    ("Duhamel", "vibration/transient-response"),
    ("earthquake", "vibration/response-spectrum"),
    ("Fourier series", "vibration/periodic-excitation"),
    ("beats", "vibration/harmonic-sum"),
    ("cantilever", "vibration/beam-with-tip-body"),
    ("viga em balanço", "vibration/beam-with-tip-body"),
    ("Rayleigh damping", "vibration/rayleigh-damping"),
    ("quarter car", "vibration/base-excitation"),
    ("cam", "virtual-work/mechanism"),
    ("slider-crank", "virtual-work/slider-crank"),
    ("biela-manivela", "virtual-work/slider-crank"),
    ("four-bar linkage", "virtual-work/four-bar"),
    ("quatro barras", "virtual-work/four-bar"),
    ("Grashof", "virtual-work/four-bar"),
    ("Whitworth", "virtual-work/quick-return"),
    ("Coriolis", "virtual-work/quick-return"),
    ("planetary gear", "virtual-work/epicyclic-train"),
    ("trem epicicloidal", "virtual-work/epicyclic-train"),
    ("flywheel", "virtual-work/flywheel"),
    ("volante", "virtual-work/flywheel"),
    ("turning moment", "virtual-work/engine"),
    ("toggle", "virtual-work/toggle-press"),
    ("governor", "rigid-body/dynamic-equilibrium"),
    ("conical pendulum", "rigid-body/dynamic-equilibrium"),
    ("gyroscope", "rigid-body/heavy-top"),
    ("pião", "rigid-body/heavy-top"),
    ("parallel axis theorem", "rigid-body/mass-properties"),
    ("products of inertia", "rigid-body/mass-properties"),
    ("Euler angles", "rigid-body/attitude"),
    ("separatrix", "rigid-body/free-triaxial"),
    ("hammer blow", "balancing/locomotive"),
    ("influence coefficients", "balancing/field"),
    ("balanceamento dinâmico", "balancing/two-plane"),
];

/// The analyses of a search, the best match first.
fn found(words: &str) -> Vec<&'static Entry> {
    let indices: Vec<Index> = registry()
        .iter()
        .map(|entry| Index::of(entry, &cases::cases(entry).expect("the cases can be read")))
        .collect();
    let indices: Vec<&Index> = indices.iter().collect();
    search::find(&indices, words).into_iter().map(|found| registry()[found.place]).collect()
}

#[test]
fn words_of_textbooks_find_their_analysis_among_the_first_three() {
    let indices: Vec<Index> = registry()
        .iter()
        .map(|entry| Index::of(entry, &cases::cases(entry).expect("the cases can be read")))
        .collect();
    let indices: Vec<&Index> = indices.iter().collect();
    let mut missed = Vec::new();
    for (words, id) in WORDS {
        // Capitals and accents do not matter.
        for words in [words.to_owned(), words.to_uppercase(), dalembert_core::ascii(words)] {
            let first: Vec<&str> = search::find(&indices, &words)
                .into_iter()
                .take(3)
                .map(|found| registry()[found.place].about.id)
                .collect();
            if !first.contains(&id) {
                missed.push(format!("{words}: {id} is not among {first:?}"));
            }
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn symbols_and_labels_of_inputs_and_answers_are_searched() {
    for (words, id) in [
        ("m₀e", "vibration/rotating-unbalance"),
        ("speed of the machine", "vibration/rotating-unbalance"),
        ("rotação da máquina", "vibration/rotating-unbalance"),
        ("wire diameter", "vibration/rotating-unbalance"),
        ("peak frequency", "vibration/rotating-unbalance"),
    ] {
        assert!(found(words).iter().any(|entry| entry.about.id == id), "{words}");
    }
}

#[test]
fn the_workbench_and_the_command_line_find_the_same() {
    for words in ["critical speed", "khurmi", "pião", "rotunb", "V-twin"] {
        let mut person = Person::at(80, 24);
        person.types("/").types(words);
        let rows = person.model.picker.rows(person.model.contents());
        let shown: Vec<&str> = rows
            .iter()
            .filter_map(|row| match row {
                Row::Leaf(leaf) => Some(person.model.listings[leaf.listing].entry.about.id),
                Row::Heading(_) => None,
            })
            .collect();
        assert_eq!(shown, found(words).iter().map(|entry| entry.about.id).collect::<Vec<_>>(), "{words}");
    }
}
