//! LaTeX writer: a document for pdfLaTeX, XeLaTeX and LuaLaTeX alike, one file, its figures drawn by TikZ.

use dalembert_core::{ascii, printer::WrittenStep};

use crate::{
    PROGRAM,
    document::{Block, Document, DocumentTable, NamedValue, column_widths, is_heading},
    figure::picture::tikz_colours,
    math::{
        self, Math,
        breaking::{room_beside, set_in_pieces},
        closing,
        prose::set_in_words,
        sides,
    },
};

const PREAMBLE: &str = r"\documentclass[11pt,a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{textcomp}
\usepackage{amsmath}
\usepackage[margin=2.5cm]{geometry}
\usepackage{array}
\usepackage{longtable}
\usepackage{tikz}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
% What hangs below the last line belongs to the page.
\maxdepth=0pt
\newlength{\lead}
% A side of an equation behind its symbol: its lines are broken where it says, and aligned behind the equals sign.
\newcommand{\side}[2]{\settowidth{\lead}{$\displaystyle #1={}$}%
  \noindent\hangindent=\lead\hangafter=1\hbox to\lead{$\displaystyle #1={}$\hfil}#2\par\nopagebreak}
% The sides of an equation stay on one page.
\newenvironment{equation-sides}{\leftskip=2em\rightskip=0pt plus 0.5\linewidth\tolerance=10000\lineskiplimit=4pt\lineskip=4pt
  \interlinepenalty=10000\samepage}{\par\penalty-20}
\newcommand{\piece}[1]{\hbox{$\displaystyle #1$}}
% A line ends rather before a term than before a factor.
\newcommand{\term}{\penalty0\hskip0pt\relax}
\newcommand{\factor}{\penalty500\hskip0pt\relax}
% A column of words, and one of numbers, that are wrapped.
\newcolumntype{L}[1]{>{\raggedright\arraybackslash\hspace{0pt}}p{#1}}
\newcolumntype{R}[1]{>{\raggedleft\arraybackslash\hspace{0pt}}p{#1}}
\emergencystretch=3em
% A title begins another page where there is no room for what follows: so many lines.
\makeatletter
\newcommand{\room}[1][8]{\par\if@nobreak\else\ifdim\pagetotal>0pt
  \ifdim\dimexpr\pagegoal-\pagetotal\relax<#1\baselineskip\newpage\fi\fi\fi}
\makeatother
% What follows stays on the page.
\newcommand{\keep}{\par\nopagebreak}
";

/// Foot of a page: program and version, page of pages. The second run knows how many there are.
const FOOT: &str = r"\makeatletter
\@maxdepth=\maxdepth
\def\@oddfoot{PROGRAM\hfil\thepage\ / \pageref{last-page}}
\makeatother
";

/// Digits on a line of a table, and those that the gap between two columns takes.
const COLUMNS: f64 = 82.0;
const GAP: f64 = 1.7;

/// Room for a side of a formula, in ems.
const ROOM: f64 = 34.0;

/// The document in LaTeX.
pub fn latex(document: &Document) -> String {
    let blocks: Vec<String> = (0..document.blocks.len()).map(|at| block(&document.blocks, at)).collect();
    format!(
        "{PREAMBLE}{}{}\\begin{{document}}\n\\section*{{{}}}\n\n{}\n\\label{{last-page}}\n\\end{{document}}\n",
        FOOT.replace("PROGRAM", PROGRAM),
        tikz_colours(),
        words(&document.title),
        blocks.join("\n")
    )
}

/// The steps of the document as one formula of LaTeX, a step a line, to stand between `$$`: `k &= 3 E I / L^3 = …`.
pub fn latex_formulas(document: &Document) -> String {
    let lines = document.blocks.iter().filter_map(|block| match block {
        Block::Step(_, step) => {
            let sides: Vec<String> = sides(step).iter().map(set).collect();
            Some(format!("{} &= {}", set(&math::symbols(&step.symbol)), sides.join(" = ")))
        }
        _ => None,
    });
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", lines.collect::<Vec<_>>().join(" \\\\\n"))
}

fn block(blocks: &[Block], at: usize) -> String {
    match &blocks[at] {
        Block::Heading(heading) => {
            let has_title_below = matches!(blocks.get(at + 1), Some(Block::Subheading(_)));
            let lines = if has_title_below { "[11]" } else { "" };
            format!("\\room{lines}\\subsection*{{{}}}\n", prose(heading))
        }
        Block::Subheading(heading) => format!("\\room\\subsubsection*{{{}}}\n", prose(heading)),
        Block::Paragraph(sentences) => format!("{}\n", prose(sentences)),
        Block::Items(items) => {
            let items =
                items.iter().map(|item| format!("\\item {{}}{}\n", prose(item))).collect::<Vec<_>>().concat();
            format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n")
        }
        Block::TitleBlock(lines) => {
            let line = |line: &NamedValue| {
                format!("{{}}{} & {} \\\\ \\hline\n", words(&line.label), words(&line.value))
            };
            let lines = lines.iter().map(line).collect::<String>();
            format!("\\begin{{tabular}}{{|l|p{{0.6\\linewidth}}|}}\n\\hline\n{lines}\\end{{tabular}}\n")
        }
        Block::Lines(lines) => format!(
            "\\begin{{longtable}}[l]{{@{{}}p{{0.55\\linewidth}}lp{{0.25\\linewidth}}@{{}}}}\n{}\\end{{longtable}}\n",
            pairs(lines)
        ),
        Block::Step(number, step) => written_step(*number, step),
        Block::Table(table) => rows(table),
        Block::Figure(picture) => format!(
            "\\begin{{center}}\n{}\n\\smallskip\n{}\n\\end{{center}}\n",
            picture.tikz(words),
            prose(&picture.title)
        ),
    }
}

/// Names with values; a heading stays beside the first of its lines.
fn pairs(lines: &[NamedValue]) -> String {
    let row = |(at, line): (usize, &NamedValue)| {
        format!("{}\\\\{}\n", pair(line), if is_heading(lines, at) { "*" } else { "" })
    };
    lines.iter().enumerate().map(row).collect::<Vec<_>>().concat()
}

fn pair(line: &NamedValue) -> String {
    let symbol = if line.symbol.is_empty() {
        String::new()
    } else {
        format!("${}$", set(&math::symbols(&line.symbol)))
    };
    let indent = if line.depth == 0 { String::new() } else { format!("\\hspace*{{{}em}}", line.depth) };
    format!("{{}}{indent}{} & {symbol} & {} ", prose(&line.label), words(&line.value))
}

/// A side of a formula, in pieces between which a line may end.
fn side(formula: &Math, room: f64) -> String {
    let terms = set_in_pieces(formula, room, |piece, is_behind_another| {
        let before = if is_behind_another { "{}" } else { "" };
        format!("\\piece{{{before}{}}}", set(piece))
    });
    terms.iter().map(|pieces| pieces.join("\\factor")).collect::<Vec<_>>().join("\\term")
}

fn written_step(number: usize, step: &WrittenStep) -> String {
    let source = if step.source.is_empty() { String::new() } else { format!(" ({})", words(&step.source)) };
    let mut text =
        format!("\\textbf{{{number}.}} {}{source}\\keep\n\\begin{{equation-sides}}\n", prose(&step.why));
    let symbol = math::symbols(&step.symbol);
    let room = room_beside(&symbol, ROOM);
    let symbol = set(&symbol);
    for (n, formula) in sides(step).iter().enumerate() {
        let left = if n == 0 { symbol.clone() } else { format!("\\phantom{{{symbol}}}") };
        text += &format!("\\side{{{left}}}{{{}}}\n", side(formula, room));
    }
    text += "\\end{equation-sides}\n";
    if !step.terms.is_empty() {
        let terms = step
            .terms
            .iter()
            .map(|(term, value)| format!("${}$ & {} \\\\\n", set(&math::symbols(term)), words(value)));
        text += &format!("\\begin{{longtable}}{{lr}}\n{}\\end{{longtable}}\n", terms.collect::<String>());
    }
    text
}

fn rows(table: &DocumentTable) -> String {
    let row = |cells: &[String]| {
        let cells: Vec<String> =
            (0..table.columns.len()).map(|at| prose(cells.get(at).map_or("", String::as_str))).collect();
        // A cell that begins with a bracket would be taken for an option of the line break before it.
        format!("{{}}{} \\\\\n", cells.join(" & "))
    };
    let is_number = |at: usize| table.numeric.get(at) == Some(&true);
    let widths = column_widths(table, COLUMNS);
    let all: f64 = widths.iter().sum::<f64>() + GAP * widths.len() as f64;
    // Columns as wide as their cells where there is room, else wrapped, and in letters as small as they must be.
    let natural: f64 = column_widths(table, f64::INFINITY).iter().sum();
    let sides: String = if natural + GAP * widths.len() as f64 <= COLUMNS {
        (0..table.columns.len()).map(|at| if is_number(at) { 'r' } else { 'l' }).collect()
    } else {
        let column = |(at, width): (usize, &f64)| {
            let kind = if is_number(at) { 'R' } else { 'L' };
            format!("{kind}{{{:.3}\\linewidth}}", 0.99 * width / all.max(COLUMNS))
        };
        widths.iter().enumerate().map(column).collect::<Vec<_>>().concat()
    };
    // Small letters are wider than their size says.
    let size = match COLUMNS / all {
        share if share >= 1.0 => "",
        share if share >= 0.92 => "\\small",
        share if share >= 0.85 => "\\footnotesize",
        share if share >= 0.78 => "\\scriptsize",
        _ => "\\tiny",
    };
    let title = if table.title.is_empty() {
        String::new()
    } else {
        format!("\\room\\textbf{{{}}}\\keep\n", prose(&table.title))
    };
    let foot = if table.foot.is_empty() { String::new() } else { format!("\\hline\n{}", row(&table.foot)) };
    format!(
        "{title}{{{size}\\tabcolsep=0.4em\n\\begin{{longtable}}{{{sides}}}\n{}\\hline\n\\endhead\n{}{foot}\\end{{longtable}}}}\n",
        row(&table.columns),
        table.rows.iter().map(|cells| row(cells)).collect::<String>()
    )
}

/// A formula, to stand within `$`.
fn set(formula: &Math) -> String {
    match formula {
        Math::Row(parts) => parts.iter().map(set).collect::<Vec<_>>().join(" "),
        Math::Number(digits) => digits.replace(',', "{,}"),
        Math::Upright(text) => match text.as_str() {
            "sin" | "cos" | "tan" | "arcsin" | "arccos" | "arctan" | "exp" | "ln" => format!("\\{text}"),
            _ => format!("\\mathrm{{{}}}", letters(text)),
        },
        Math::Symbol(base, index) => format!("{}{}", symbol(base), lowered(index)),
        // Without braces, so that it keeps the room of a sign.
        Math::Operator(sign) => match COMMANDS.iter().find(|(like, _)| like == sign) {
            Some((_, command)) => (*command).to_owned(),
            None => letters(&sign.to_string()),
        },
        Math::Gap => "\\,".to_owned(),
        Math::Fraction(top, bottom) => format!("\\frac{{{}}}{{{}}}", set(top), set(bottom)),
        Math::Root(degree, of) if degree.is_empty() => format!("\\sqrt{{{}}}", set(of)),
        Math::Root(degree, of) => format!("\\sqrt[{}]{{{}}}", letters(degree), set(of)),
        Math::Power(base, power) => format!("{{{}}}^{{{}}}", set(base), letters(power)),
        Math::Index(base, index) => format!("{{{}}}{}", set(base), lowered(index)),
        Math::Brackets(open, inner) => {
            let close = closing(*open);
            format!("\\left{open}{}\\right{close}", set(inner))
        }
    }
}

fn lowered(index: &str) -> String {
    match index.chars().count() {
        0 => String::new(),
        1 => format!("_{{{}}}", letters(index)),
        _ => format!("_{{\\mathrm{{{}}}}}", letters(index)),
    }
}

fn symbol(base: &str) -> String {
    let mut characters = base.chars();
    match (characters.next(), characters.next(), characters.next()) {
        (Some(_), None, _) => letters(base),
        (Some(letter), Some('\u{307}'), None) => format!("\\dot{{{}}}", letters(&letter.to_string())),
        (Some(letter), Some('\u{308}'), None) => format!("\\ddot{{{}}}", letters(&letter.to_string())),
        (Some(letter), Some('\u{304}' | '\u{305}'), None) => {
            format!("\\bar{{{}}}", letters(&letter.to_string()))
        }
        (Some(letter), Some('\u{302}'), None) => format!("\\hat{{{}}}", letters(&letter.to_string())),
        _ => format!("\\mathit{{{}}}", letters(base)),
    }
}

/// Characters within mathematics.
fn letters(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text.chars().peekable();
    while let Some(character) = rest.next() {
        if let Some(plain) = math::lowered(character) {
            let mut power = letters(&plain.to_string());
            while let Some(plain) = rest.peek().copied().and_then(math::lowered) {
                power += &letters(&plain.to_string());
                rest.next();
            }
            out += &format!("^{{{power}}}");
        } else if let Some(plain) = math::raised(character) {
            out += &format!("_{{{}}}", letters(&plain.to_string()));
        } else if let Some((_, command)) = COMMANDS.iter().find(|(like, _)| *like == character) {
            out += &format!("{{{command}}}");
        } else {
            match character {
                '−' => out.push('-'),
                '%' | '#' | '&' | '$' | '_' | '{' | '}' => out.extend(['\\', character]),
                '\\' => out += "\\backslash{}",
                '^' => out += "\\hat{}",
                '~' => out += "\\sim{}",
                '\'' | '′' => out += "{}'",
                ' '..='~' => out.push(character),
                'À'..='ÿ' => out += &format!("\\text{{{character}}}"),
                _ => out += &format!("\\text{{{}}}", plain(character)),
            }
        }
    }
    out
}

/// Words outside of mathematics, and symbols among them.
fn prose(text: &str) -> String {
    set_in_words(text, words, |symbol| format!("${}$", set(symbol)))
}

/// Words outside of mathematics.
fn words(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text.chars().peekable();
    while let Some(character) = rest.next() {
        for (of, command) in [
            (math::lowered as fn(char) -> Option<char>, "\\textsuperscript"),
            (math::raised, "\\textsubscript"),
        ] {
            if let Some(first) = of(character) {
                let mut run = first.to_string();
                while let Some(next) = rest.peek().copied().and_then(of) {
                    run.push(next);
                    rest.next();
                }
                out += &format!("{command}{{{}}}", words(&run));
            }
        }
        if math::lowered(character).is_some() || math::raised(character).is_some() {
            continue;
        }
        if let Some((_, command)) = COMMANDS.iter().find(|(like, _)| *like == character) {
            out += &format!("\\ensuremath{{{command}}}");
            continue;
        }
        match character {
            '_' => out += "\\_\\penalty900{}",
            '%' | '#' | '&' | '$' | '{' | '}' => out.extend(['\\', character]),
            '\\' => out += "\\textbackslash{}",
            '^' => out += "\\textasciicircum{}",
            '~' => out += "\\textasciitilde{}",
            '<' => out += "\\textless{}",
            '>' => out += "\\textgreater{}",
            '|' => out += "\\textbar{}",
            '"' => out += "\\textquotedbl{}",
            '–' => out += "--",
            '—' => out += "---",
            '“' => out += "``",
            '”' => out += "''",
            '‘' => out += "`",
            '’' => out += "'",
            '…' => out += "\\ldots{}",
            'ª' => out += "\\textordfeminine{}",
            'º' => out += "\\textordmasculine{}",
            '§' => out += "\\S{}",
            '\u{A0}' => out.push('~'),
            '\n' | '\r' | '\t' => out.push(' '),
            ' '..='~' | 'À'..='ÿ' => out.push(character),
            _ => out += &words(&plain(character)),
        }
    }
    out
}

/// Replacement for a character that is in no table here.
fn plain(character: char) -> String {
    ascii(&character.to_string())
}

const COMMANDS: &[(char, &str)] = &[
    ('α', "\\alpha"),
    ('β', "\\beta"),
    ('γ', "\\gamma"),
    ('δ', "\\delta"),
    ('ε', "\\varepsilon"),
    ('ϵ', "\\epsilon"),
    ('ζ', "\\zeta"),
    ('η', "\\eta"),
    ('θ', "\\theta"),
    ('ϑ', "\\vartheta"),
    ('ι', "\\iota"),
    ('κ', "\\kappa"),
    ('λ', "\\lambda"),
    ('μ', "\\mu"),
    ('µ', "\\mu"),
    ('ν', "\\nu"),
    ('ξ', "\\xi"),
    ('π', "\\pi"),
    ('ρ', "\\rho"),
    ('σ', "\\sigma"),
    ('τ', "\\tau"),
    ('υ', "\\upsilon"),
    ('φ', "\\varphi"),
    ('ϕ', "\\phi"),
    ('χ', "\\chi"),
    ('ψ', "\\psi"),
    ('ω', "\\omega"),
    ('Γ', "\\Gamma"),
    ('Δ', "\\Delta"),
    ('Θ', "\\Theta"),
    ('Λ', "\\Lambda"),
    ('Ξ', "\\Xi"),
    ('Π', "\\Pi"),
    ('Σ', "\\Sigma"),
    ('Φ', "\\Phi"),
    ('Ψ', "\\Psi"),
    ('Ω', "\\Omega"),
    ('ℓ', "\\ell"),
    ('∂', "\\partial"),
    ('∫', "\\int"),
    ('∑', "\\sum"),
    ('√', "\\surd"),
    ('∞', "\\infty"),
    ('°', "^\\circ"),
    ('×', "\\times"),
    ('÷', "\\div"),
    ('·', "\\cdot"),
    ('⋅', "\\cdot"),
    ('±', "\\pm"),
    ('∓', "\\mp"),
    ('≤', "\\le"),
    ('≥', "\\ge"),
    ('≠', "\\ne"),
    ('≈', "\\approx"),
    ('∠', "\\angle"),
    ('→', "\\rightarrow"),
    ('←', "\\leftarrow"),
    ('↑', "\\uparrow"),
    ('↓', "\\downarrow"),
    ('↔', "\\leftrightarrow"),
    ('⇒', "\\Rightarrow"),
    ('∈', "\\in"),
    ('∪', "\\cup"),
    ('∩', "\\cap"),
    ('∅', "\\emptyset"),
    ('−', "-"),
    ('ẋ', "\\dot x"),
    ('ẍ', "\\ddot x"),
    ('ẏ', "\\dot y"),
    ('ÿ', "\\ddot y"),
    ('ż', "\\dot z"),
    ('ṙ', "\\dot r"),
    ('ṡ', "\\dot s"),
    ('Ḣ', "\\dot H"),
    ('Ṗ', "\\dot P"),
    ('Ṫ', "\\dot T"),
    ('ẇ', "\\dot w"),
    ('ℏ', "\\hbar"),
];
