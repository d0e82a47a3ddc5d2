use super::*;

/// A formula with its structure in plain letters.
fn shown(math: &Math) -> String {
    match math {
        Math::Row(parts) => parts.iter().map(shown).collect::<Vec<_>>().join(" "),
        Math::Number(text) => text.clone(),
        Math::Upright(text) => format!("'{text}'"),
        Math::Symbol(base, index) if index.is_empty() => base.clone(),
        Math::Symbol(base, index) => format!("{base}[{index}]"),
        Math::Operator(sign) => sign.to_string(),
        Math::Gap => "~".to_owned(),
        Math::Fraction(top, bottom) => format!("{{{} over {}}}", shown(top), shown(bottom)),
        Math::Root(degree, of) => format!("root{degree}{{{}}}", shown(of)),
        Math::Power(base, power) => format!("{}^{{{power}}}", shown(base)),
        Math::Index(base, index) => format!("{}[{index}]", shown(base)),
        Math::Brackets(open, inner) => format!("{open}{{{}}}", shown(inner)),
    }
}

#[test]
fn formulas_of_symbols_are_read() {
    for (text, wanted) in [
        ("3 E I / L³", "{3 ~ E ~ I over L^{3}}"),
        ("−a / (b c) + d", "− {a over b ~ c} + d"),
        ("√(k / m)", "root{{k over m}}"),
        ("³√V", "root3{V}"),
        ("m₁ r₁ cos θ₁", "m[1] ~ r[1] ~ 'cos' ~ θ[1]"),
        ("I_G₂ + Xₘₐₓ", "I[G2] + X[max]"),
        ("F / m i + g j", "{F over m} ~ i + g ~ j"),
        ("F / k", "{F over k}"),
        ("m₀e", "m[0] e"),
        ("|a − b|²", "|{a − b}^{2}"),
        ("||a| − |b||", "|{|{a} − |{b}}"),
        ("(r₁ × F)_z", "({r[1] × F}[z]"),
        ("a₁,₂", "a[1,2]"),
        ("I_xy ω₁_x", "I[xy] ~ ω[1x]"),
        ("Σ mᵢ rᵢ", "∑ m[i] ~ r[i]"),
        ("4π² f", "4 π^{2} ~ f"),
    ] {
        assert_eq!(shown(&symbols(text)), wanted, "{text}");
    }
}

#[test]
fn values_keep_their_units() {
    for (text, wanted) in [
        ("451.39 kN/m", "451.39 ~ 'kN/m'"),
        (
            "3 × 200 kN/mm² × 1,3×10⁻⁶ m⁴ / (1.2 m)³",
            "{3 × 200 ~ 'kN/mm²' × 1,3 × 10^{−6} ~ 'm⁴' over ({1.2 ~ 'm'}^{3}}",
        ),
        ("2 N / 3 m", "{2 ~ 'N' over 3 ~ 'm'}"),
        ("sin(30°)", "'sin' ({30 '°'}"),
        ("(300; 200) m/s", "({300 ; 200} ~ 'm/s'"),
        ("2 m i + 3 m j", "2 ~ 'm' ~ i + 3 ~ 'm' ~ j"),
    ] {
        assert_eq!(shown(&values(text)), wanted, "{text}");
    }
}

#[test]
fn nothing_is_refused() {
    for text in ["", "(", ")", "a)", "||", "√", "²", "/ ", "a / ", "(a", "₁", "×", "_x", "]", "Σ", "³√"]
    {
        symbols(text);
        values(text);
    }
}
