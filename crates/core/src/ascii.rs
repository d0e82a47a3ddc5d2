//! Words and symbols for terminals and printers that know ASCII alone.

/// The text in ASCII, still to be read: `ωₙ = √(k/m)` becomes `omega_n = sqrt(k/m)`.
///
/// Greek letters get their names, indices a `_`, powers a `^`; accents are dropped.
pub fn ascii(text: &str) -> String {
    if text.is_ascii() {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut before = Run::None;
    for character in text.chars() {
        if character == '\n' || (' '..='~').contains(&character) {
            // `ω t` keeps its blank, `ωt` gets one.
            if before == Run::Word && character.is_ascii_alphabetic() {
                out.push(' ');
            }
            out.push(character);
            before = Run::None;
        } else if let Some(plain) = index(character) {
            if before != Run::Index {
                out.push('_');
            }
            out.push(plain);
            before = Run::Index;
        } else if let Some(plain) = power(character) {
            if before != Run::Power {
                out.push('^');
            }
            out.push(plain);
            before = Run::Power;
        } else if let Some(word) = named(WORDS, character).or_else(|| greek(character)) {
            if out.ends_with(|last: char| last.is_ascii_alphanumeric()) {
                out.push(' ');
            }
            out.push_str(word);
            before = Run::Word;
        } else {
            match SIGNS.iter().find(|(like, _)| like.contains(character)) {
                Some((_, sign)) => out.push_str(sign),
                None => out.push('?'),
            }
            before = Run::None;
        }
    }
    out
}

/// Class of the preceding character.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Run {
    None,
    Index,
    Power,
    Word,
}

/// Pairs of a character and what it stands for, one after the other.
const INDICES: &str = "₀0₁1₂2₃3₄4₅5₆6₇7₈8₉9₊+₋-₌=₍(₎)ₐaₑeₕhᵢiⱼjₖkₗlₘmₙnₒoₚpᵣrₛsₜtᵤuᵥvₓx";
const POWERS: &str = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁺+⁻-ⁿnᵏkⁱiᵀT";

/// The Greek letters by their English names.
const GREEK: &[(char, &str)] = &[
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ϵ', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
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
];

/// Signs that are words; the capital sigma is a sum.
const WORDS: &[(char, &str)] = &[
    ('Σ', "sum"),
    ('√', "sqrt"),
    ('∠', "@"),
    ('∑', "sum"),
    ('∞', "infinity"),
    ('°', "deg"),
    ('ℓ', "l"),
    ('∂', "d"),
    ('∫', "integral"),
];

const SIGNS: &[(&str, &str)] = &[
    ("‐‑‒–—―−", "-"),
    ("·⋅×∙•", "*"),
    ("÷⁄∕", "/"),
    ("…⋯", "..."),
    ("≤", "<="),
    ("≥", ">="),
    ("≠", "!="),
    ("≈≃≅∼", "~"),
    ("±", "+/-"),
    ("∓", "-/+"),
    ("→⇒⟶", "->"),
    ("←⇐", "<-"),
    ("↔⇔", "<->"),
    ("∈", "in"),
    ("∪", "or"),
    ("∩", "and"),
    ("∅", "none"),
    ("½", "1/2"),
    ("¼", "1/4"),
    ("¾", "3/4"),
    ("‰", "permil"),
    ("§", "sec. "),
    ("‘’′ʹ", "'"),
    ("“”„″", "\""),
    ("«", "<<"),
    ("»", ">>"),
    ("©", "(c)"),
    ("µ", "u"),
    ("✓✔", "ok"),
    ("✗✘", "x"),
    ("\u{A0}\u{2007}\u{2008}\u{2009}\u{200A}\u{202F}\t", " "),
    // Time derivatives: dots are primes.
    ("\u{307}", "'"),
    ("\u{308}", "''"),
    ("ẋ", "x'"),
    ("ẍ", "x''"),
    ("ẏ", "y'"),
    ("ÿ", "y''"),
    ("ż", "z'"),
    ("ṙ", "r'"),
    ("ṡ", "s'"),
    ("Ḣ", "H'"),
    ("Ṗ", "P'"),
    ("Ṫ", "T'"),
    ("ẇ", "w'"),
    ("\u{300}\u{301}\u{302}\u{303}\u{304}\u{327}", ""),
    ("áàâãäåā", "a"),
    ("ÁÀÂÃÄÅ", "A"),
    ("ç", "c"),
    ("Ç", "C"),
    ("éèêë", "e"),
    ("ÉÈÊË", "E"),
    ("íìîï", "i"),
    ("ÍÌÎÏ", "I"),
    ("ñ", "n"),
    ("Ñ", "N"),
    ("óòôõöø", "o"),
    ("ÓÒÔÕÖØ", "O"),
    ("úùûü", "u"),
    ("ÚÙÛÜ", "U"),
    ("ý", "y"),
    ("Ý", "Y"),
    ("ß", "ss"),
    ("æ", "ae"),
    ("Æ", "AE"),
    ("ªº", ""),
];

/// The plain character that a lowered one stands for: `₂` is `2`.
pub fn index(character: char) -> Option<char> {
    among(INDICES, character)
}

/// The plain character that a raised one stands for: `²` is `2`.
pub fn power(character: char) -> Option<char> {
    among(POWERS, character)
}

/// The English name of a Greek letter: `ω` is `omega`.
pub fn greek(character: char) -> Option<&'static str> {
    named(GREEK, character)
}

fn named(names: &[(char, &'static str)], character: char) -> Option<&'static str> {
    names.iter().find(|(like, _)| *like == character).map(|(_, name)| *name)
}

/// The character that stands behind another one in a text of such pairs.
fn among(pairs: &str, character: char) -> Option<char> {
    let mut pairs = pairs.chars();
    while let (Some(like), Some(plain)) = (pairs.next(), pairs.next()) {
        if like == character {
            return Some(plain);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_stay_readable() {
        for (unicode, plain) in [
            ("ωₙ = √(k/m)", "omega_n = sqrt(k/m)"),
            ("1/(2ζ√(1−ζ²))", "1/(2 zeta sqrt(1-zeta^2))"),
            ("Xₘₐₓ ≤ 2 m·s⁻²", "X_max <= 2 m*s^-2"),
            ("θ̈ + ẋ", "theta'' + x'"),
            ("m₀e", "m_0e"),
            ("Vibrações Mecânicas, 6ª edição, §3.7", "Vibracoes Mecanicas, 6 edicao, sec. 3.7"),
            ("30° — 5", "30 deg - 5"),
        ] {
            assert_eq!(ascii(unicode), plain);
        }
    }

    #[test]
    fn nothing_but_ascii_comes_out() {
        let all: String = ('\0'..'\u{3000}').collect();
        assert!(ascii(&all).chars().all(|c| c == '\n' || (' '..='~').contains(&c)));
    }
}
