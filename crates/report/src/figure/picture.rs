//! Lines, areas and words at their places, and how they are written as SVG and as TikZ.
//!
//! Lengths are CSS pixels, `y` down. TikZ comes with every TeX and needs neither a converter nor a second file, which
//! SVG does in LaTeX.

use crate::xml;

/// The height of words.
pub const WORDS: f64 = 13.0;

/// A picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Title.
    pub title: String,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Parts, later ones over earlier ones.
    pub parts: Vec<PictureElement>,
    /// The same in letters of fixed pitch, a line each; none where it could not be read so.
    pub letters: Vec<String>,
}

/// A part of a picture.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureElement {
    /// Straight lines from point to point.
    Line {
        /// The points.
        points: Vec<(f64, f64)>,
        /// Their colour.
        tone: Tone,
        /// Their width.
        width: f64,
        /// Line style.
        dash: LineStyle,
    },
    /// A filled disc.
    Disc {
        /// Centre.
        at: (f64, f64),
        /// Radius.
        radius: f64,
        /// Colour role.
        tone: Tone,
    },
    /// A filled rectangle.
    Area {
        /// Upper left corner.
        from: (f64, f64),
        /// Lower right corner.
        to: (f64, f64),
        /// Colour role.
        tone: Tone,
        /// Opacity, from 0 to 1.
        opacity: f64,
    },
    /// Words on one line.
    Words {
        /// A point of their base line.
        at: (f64, f64),
        /// Anchor of the text at the point.
        anchor: Anchor,
        /// The words.
        text: String,
        /// Their colour.
        tone: Tone,
    },
}

/// Colour role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The colour of the words around.
    Ink,
    /// The same, faint: grids, centre lines.
    Faint,
    /// The curve of that place.
    Curve(usize),
    /// Permitted range.
    Good,
    /// Forbidden range.
    Bad,
    /// A place on the scale of a map, from 0 for the least value to 255 for the largest.
    Scale(u8),
}

/// Line style: curves can be distinguished without colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineStyle {
    /// Not at all.
    Solid,
    /// Long dashes.
    Long,
    /// Short dashes.
    Short,
    /// Dashes and dots.
    Mixed,
}

/// Anchor of a text at its point: start, middle or end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Their beginning.
    Start,
    /// Their middle.
    Middle,
    /// Their end.
    End,
}

/// The colours of curves: of middle brightness, so that they stand out on white and on black.
const CURVES: [&str; 6] = ["2878C8", "D0700C", "2A9658", "C84864", "8660C8", "188E98"];
/// The scale of maps, red, green and blue at equal distances: viridis, whose brightness rises evenly, so that it is read
/// in print and by the colour-blind too (S. van der Walt and N. Smith, 2015).
const SCALE: [[f64; 3]; 5] =
    [[68.0, 1.0, 84.0], [59.0, 82.0, 139.0], [33.0, 145.0, 140.0], [94.0, 201.0, 98.0], [253.0, 231.0, 37.0]];

impl Tone {
    /// Red, green and blue; `None` for the colour of the words around.
    pub(crate) fn channels(self) -> Option<[u8; 3]> {
        let of_curve = |n: usize| {
            let rgb = u32::from_str_radix(CURVES[n % CURVES.len()], 16).unwrap_or_default().to_be_bytes();
            [rgb[1], rgb[2], rgb[3]]
        };
        match self {
            Tone::Ink | Tone::Faint => None,
            Tone::Curve(n) => Some(of_curve(n)),
            Tone::Good => Some(of_curve(2)),
            Tone::Bad => Some(of_curve(3)),
            Tone::Scale(place) => Some(of_scale(place)),
        }
    }

    /// The same as six hexadecimal digits.
    fn rgb(self) -> Option<String> {
        self.channels().map(|[red, green, blue]| format!("{red:02X}{green:02X}{blue:02X}"))
    }
}

/// The colour at a place of the scale of maps.
fn of_scale(place: u8) -> [u8; 3] {
    let at = f64::from(place) / 255.0 * (SCALE.len() - 1) as f64;
    let below = (at as usize).min(SCALE.len() - 2);
    let share = at - below as f64;
    std::array::from_fn(|n| ((1.0 - share) * SCALE[below][n] + share * SCALE[below + 1][n]).round() as u8)
}

impl LineStyle {
    /// The dash of the curve of that place.
    pub fn of_curve(n: usize) -> Self {
        [LineStyle::Solid, LineStyle::Long, LineStyle::Short, LineStyle::Mixed][n % 4]
    }

    pub(crate) fn lengths(self) -> &'static [u32] {
        match self {
            LineStyle::Solid => &[],
            LineStyle::Long => &[9, 4],
            LineStyle::Short => &[3, 3],
            LineStyle::Mixed => &[9, 3, 2, 3],
        }
    }
}

impl Picture {
    /// The picture as an SVG that needs nothing else. Lines and words take the colour of the page; alone, they are
    /// dark, or light for those who ask for dark pages.
    pub fn svg(&self) -> String {
        let (width, height) = (short(self.width), short(self.height));
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" role=\"img\" font-family=\"sans-serif\" font-size=\"{}\">\n<title>{}</title>\n\
             <style>:root {{ color: #1c1c1c }} @media (prefers-color-scheme: dark) {{ :root {{ color: #e4e4e4 }} \
             }}</style>\n",
            short(WORDS),
            xml::escaped(&self.title)
        );
        for part in &self.parts {
            text += &svg(part);
            text.push('\n');
        }
        text + "</svg>\n"
    }

    /// The picture as a `tikzpicture`, its words passed through `set`. Its colours are those of [`tikz_colours`].
    pub fn tikz(&self, set: impl Fn(&str) -> String) -> String {
        let mut text = "\\begin{tikzpicture}[x=0.02cm,y=-0.02cm,line join=round]\n".to_owned();
        for part in &self.parts {
            text += &tikz(part, &set);
            text.push('\n');
        }
        text + "\\end{tikzpicture}\n"
    }
}

/// The colours that a `tikzpicture` uses, for the preamble.
pub fn tikz_colours() -> String {
    let colour = |(n, rgb): (usize, &&str)| format!("\\definecolor{{curve{n}}}{{HTML}}{{{rgb}}}\n");
    CURVES.iter().enumerate().map(colour).collect()
}

fn svg(part: &PictureElement) -> String {
    let paint = |tone: &Tone| tone.rgb().map_or_else(|| "currentColor".to_owned(), |rgb| format!("#{rgb}"));
    let faint = |tone: &Tone| if *tone == Tone::Faint { " opacity=\"0.35\"" } else { "" };
    match part {
        PictureElement::Line { points, tone, width, dash } => {
            let dash = match dash.lengths() {
                [] => String::new(),
                lengths => {
                    let lengths: Vec<String> = lengths.iter().map(u32::to_string).collect();
                    format!(" stroke-dasharray=\"{}\"", lengths.join(" "))
                }
            };
            let points: Vec<String> =
                points.iter().map(|(x, y)| format!("{},{}", short(*x), short(*y))).collect();
            format!(
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{dash}{} \
                 stroke-linejoin=\"round\"/>",
                points.join(" "),
                paint(tone),
                short(*width),
                faint(tone)
            )
        }
        PictureElement::Disc { at, radius, tone } => format!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"{}/>",
            short(at.0),
            short(at.1),
            short(*radius),
            paint(tone),
            faint(tone)
        ),
        PictureElement::Area { from, to, tone, opacity } => format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"{}/>",
            short(from.0),
            short(from.1),
            short(to.0 - from.0),
            short(to.1 - from.1),
            paint(tone),
            // Cells that touch show no seams.
            if *opacity < 1.0 {
                format!(" opacity=\"{opacity}\"")
            } else {
                " shape-rendering=\"crispEdges\"".to_owned()
            }
        ),
        PictureElement::Words { at, anchor, text, tone } => {
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            format!(
                "<text x=\"{}\" y=\"{}\"{anchor} fill=\"{}\">{}</text>",
                short(at.0),
                short(at.1),
                paint(tone),
                xml::escaped(text)
            )
        }
    }
}

fn tikz(part: &PictureElement, set: &impl Fn(&str) -> String) -> String {
    let paint = |tone: &Tone| match tone {
        Tone::Ink => "black".to_owned(),
        Tone::Faint => "black!35".to_owned(),
        Tone::Curve(n) => format!("curve{}", n % CURVES.len()),
        Tone::Good => "curve2".to_owned(),
        Tone::Bad => "curve3".to_owned(),
        Tone::Scale(place) => {
            let [red, green, blue] = of_scale(*place);
            format!("color={{rgb,255:red,{red};green,{green};blue,{blue}}}")
        }
    };
    let place = |(x, y): &(f64, f64)| format!("({},{})", short(*x), short(*y));
    match part {
        PictureElement::Line { points, tone, width, dash } => {
            let dash = match dash.lengths() {
                [] => String::new(),
                lengths => {
                    let runs = lengths
                        .iter()
                        .enumerate()
                        .map(|(n, length)| format!("{} {length}bp", if n % 2 == 0 { "on" } else { "off" }));
                    format!(",dash pattern={}", runs.collect::<Vec<_>>().join(" "))
                }
            };
            // TeX reads short lines only.
            let mut path = String::new();
            for (n, point) in points.iter().enumerate() {
                path += if n == 0 {
                    " "
                } else if n % 6 == 0 {
                    "\n  -- "
                } else {
                    " -- "
                };
                path += &place(point);
            }
            format!("\\draw[{},line width={}bp{dash}]{path};", paint(tone), short(0.6 * width))
        }
        PictureElement::Disc { at, radius, tone } => {
            format!("\\fill[{}] {} circle[radius={}bp];", paint(tone), place(at), short(0.6 * radius))
        }
        PictureElement::Area { from, to, tone, opacity } => {
            format!("\\fill[{},opacity={opacity}] {} rectangle {};", paint(tone), place(from), place(to))
        }
        PictureElement::Words { at, anchor, text, tone } => {
            let anchor = match anchor {
                Anchor::Start => "base west",
                Anchor::Middle => "base",
                Anchor::End => "base east",
            };
            format!(
                "\\node[{},anchor={anchor},inner sep=0pt,font=\\footnotesize] at {} {{{}}};",
                paint(tone),
                place(at),
                set(text)
            )
        }
    }
}

/// A length with no more digits than can be seen.
pub(crate) fn short(length: f64) -> String {
    let text = format!("{length:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
