//! Names compared as people write them: `ω_n`, `ωₙ` and `omega_n` are one name.

/// The Greek letters by their English names.
const GREEK: [(char, &str); 37] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
    ('∆', "Delta"),
];

/// Raised and lowered letters and digits, beside the plain ones.
const INDICES: [(char, char); 30] = [
    ('₀', '0'),
    ('₁', '1'),
    ('₂', '2'),
    ('₃', '3'),
    ('₄', '4'),
    ('₅', '5'),
    ('₆', '6'),
    ('₇', '7'),
    ('₈', '8'),
    ('₉', '9'),
    ('ₐ', 'a'),
    ('ₑ', 'e'),
    ('ₒ', 'o'),
    ('ₓ', 'x'),
    ('ₕ', 'h'),
    ('ₖ', 'k'),
    ('ₗ', 'l'),
    ('ₘ', 'm'),
    ('ₙ', 'n'),
    ('ₚ', 'p'),
    ('ₛ', 's'),
    ('ₜ', 't'),
    ('ᵢ', 'i'),
    ('ⱼ', 'j'),
    ('ᵣ', 'r'),
    ('ᵤ', 'u'),
    ('ᵥ', 'v'),
    ('₊', '+'),
    ('₋', '-'),
    ('′', '\''),
];

/// A name without what may be written in several ways: Greek letters spelled out, indices on the line, without `_`
/// and brackets, so that `m[2]`, `m_2` and `m₂` are one name. A comma between indices stays.
pub(crate) fn normalised(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        if let Some((_, spelled)) = GREEK.iter().find(|(letter, _)| *letter == c) {
            text += spelled;
        } else if let Some((_, plain)) = INDICES.iter().find(|(index, _)| *index == c) {
            text.push(*plain);
        } else if !matches!(c, '_' | '[' | ']' | ' ') {
            text.push(c);
        }
    }
    text
}
