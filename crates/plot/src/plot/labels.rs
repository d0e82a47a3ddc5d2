//! Words beside points, none over another.

use dalembert_core::LabelSide;
use ratatui::{buffer::Buffer, layout::Rect, style::Style};
use unicode_width::UnicodeWidthStr;

/// The words that stand in an area.
pub(crate) struct Labels {
    area: Rect,
    placed: Vec<Placed>,
}

/// Words in their cells, and the point that they belong to; without words, a cell that is kept free.
struct Placed {
    at: Rect,
    words: String,
    style: Style,
    point: Option<(u16, u16)>,
}

impl Labels {
    /// None yet.
    pub(crate) fn new(area: Rect) -> Self {
        Self { area, placed: Vec::new() }
    }

    /// Words at one of `places` (of their first cell): the one where they cover fewest cells that are not `free` and
    /// are least `far` (in cells that may be covered to be nearer), the first of several. Says whether there was one;
    /// where a third of the words would cover something else, the words give way.
    pub(crate) fn put(
        &mut self,
        words: &str,
        style: Style,
        places: impl IntoIterator<Item = (i32, i32)>,
        far: impl Fn(&Rect) -> usize,
        free: impl Fn(u16, u16) -> bool,
    ) -> bool {
        self.least(words, style, None, places, |covered, at| covered + far(at), free)
    }

    /// Words of a point at the place of least price, which is that of the cells that they would cover and of the place.
    fn least(
        &mut self,
        words: &str,
        style: Style,
        point: Option<(u16, u16)>,
        places: impl IntoIterator<Item = (i32, i32)>,
        price: impl Fn(usize, &Rect) -> usize,
        free: impl Fn(u16, u16) -> bool,
    ) -> bool {
        let width = u16::try_from(words.width()).unwrap_or(u16::MAX);
        if width == 0 {
            return true;
        }
        // The cells at both ends count too, so that words keep a distance where there is a choice.
        let covered = |at: &Rect| (at.x.saturating_sub(1)..=at.right()).filter(|x| !free(*x, at.y)).count();
        let best = places
            .into_iter()
            .filter_map(|place| self.rect(place, width))
            .map(|at| (covered(&at), at))
            .min_by_key(|(covered, at)| price(*covered, at));
        let Some((_, at)) = best.filter(|(covered, _)| 3 * covered <= usize::from(width) + 3) else {
            return false;
        };
        // A blank at each end, so that words stand off from what is shaded.
        let blank =
            |x: u16| x >= self.area.x && x < self.area.right() && free(x, at.y) && !self.is_taken(x, at.y);
        let (before, after) = (at.x > 0 && blank(at.x - 1), blank(at.right()));
        let whole =
            Rect { x: at.x - u16::from(before), width: width + u16::from(before) + u16::from(after), ..at };
        let words = format!("{}{words}{}", if before { " " } else { "" }, if after { " " } else { "" });
        self.placed.push(Placed { at: whole, words, style, point });
        true
    }

    /// Words beside a point: right or left of it, above or below.
    pub(crate) fn beside(
        &mut self,
        words: &str,
        style: Style,
        (x, y): (u16, u16),
        free: impl Fn(u16, u16) -> bool,
    ) -> bool {
        let (x, y, width) = (i32::from(x), i32::from(y), words.width() as i32);
        let (right, left, middle) = (x + 2, x - 1 - width, x - width / 2);
        let places = [
            (right, y),
            (left, y),
            (right, y - 1),
            (left, y - 1),
            (right, y + 1),
            (left, y + 1),
            (middle, y - 1),
            (middle, y + 1),
            (right, y - 2),
            (left, y - 2),
            (right, y + 2),
            (left, y + 2),
        ];
        // Words two rows away may belong to anything: they stand there only to cover much less.
        self.put(words, style, places, |at| if at.y.abs_diff(y as u16) > 1 { 3 } else { 0 }, free)
    }

    /// Words at a side of a point, farther out where they would cover something, or at the nearest side where they do not.
    pub(crate) fn at_side(
        &mut self,
        words: &str,
        style: Style,
        (x, y): (u16, u16),
        side: LabelSide,
        free: impl Fn(u16, u16) -> bool,
    ) -> bool {
        let point = Some((x, y));
        let (x, y, width) = (i32::from(x), i32::from(y), words.width() as i32);
        let mut sides = LabelSide::AROUND;
        sides.sort_by_key(|other| side.turn_to(*other));
        let mut places = Vec::new();
        if side == LabelSide::Over {
            places.push(((x - width / 2, y), 0));
        }
        for other in sides {
            let (right, up) = other.direction();
            for step in 0..4i32 {
                // At most two cells between the words and their point.
                let gap = step.min(1);
                let left = match right {
                    right if right > 0.1 => x + 2 + gap,
                    right if right < -0.1 => x - 1 - width - gap,
                    _ => x - width / 2,
                };
                let row = match up {
                    up if up > 0.1 => y - 1 - step / 2,
                    up if up < -0.1 => y + 1 + step / 2,
                    _ => y,
                };
                places.push(((left, row), side.turn_to(other) + step as usize));
            }
        }
        let price = |at: &Rect| {
            let place = (i32::from(at.x), i32::from(at.y));
            places.iter().find(|(other, _)| *other == place).map_or(0, |(_, price)| *price)
        };
        // A step farther out is better than a cell that is covered.
        let price = |covered: usize, at: &Rect| 3 * covered + price(at);
        self.least(words, style, point, places.iter().map(|(place, _)| *place), price, free)
    }

    /// A sign of a few cells at a point or next to it, over whatever is drawn there but no words; nowhere if there are
    /// words all round.
    pub(crate) fn mark(
        &mut self,
        sign: &str,
        style: Style,
        (x, y): (u16, u16),
        free: impl Fn(u16, u16) -> bool,
    ) {
        let point = Some((x, y));
        let (x, y, width) = (i32::from(x), i32::from(y), sign.width() as u16);
        let near = [-1, 0, 1].into_iter().flat_map(|down| [0, 1, -1].map(|across| (x + across, y + down)));
        let places = near.filter_map(|place| self.rect(place, width));
        let at = places.min_by_key(|at| (at.x..at.right()).filter(|x| !free(*x, at.y)).count());
        self.placed.extend(at.map(|at| Placed { at, words: sign.to_owned(), style, point }));
    }

    /// The words of points: the cells they take, and the cells of their points.
    pub(crate) fn placed(&self) -> Vec<(Rect, String, (u16, u16))> {
        let of_point = |placed: &Placed| Some((placed.at, placed.words.clone(), placed.point?));
        self.placed.iter().filter_map(of_point).collect()
    }

    /// The cells of all words.
    pub(crate) fn cells(&self) -> impl Iterator<Item = Rect> {
        self.placed.iter().filter(|placed| !placed.words.is_empty()).map(|placed| placed.at)
    }

    /// Keeps a cell free of words.
    pub(crate) fn reserve(&mut self, (x, y): (u16, u16)) {
        let at = Rect::new(x, y, 1, 1);
        self.placed.push(Placed { at, words: String::new(), style: Style::new(), point: None });
    }

    /// Writes them.
    pub(crate) fn draw(&self, buffer: &mut Buffer) {
        for Placed { at, words, style, .. } in &self.placed {
            // Letters are of one colour, whatever they stand on.
            for x in at.x..at.x + words.width() as u16 {
                buffer[(x, at.y)].reset();
            }
            buffer.set_string(at.x, at.y, words, *style);
        }
    }

    fn is_taken(&self, x: u16, y: u16) -> bool {
        self.placed.iter().any(|other| other.at.contains((x, y).into()))
    }

    /// The cells of words of that width, where they lie inside the area and over no others.
    fn rect(&self, (x, y): (i32, i32), width: u16) -> Option<Rect> {
        let at = Rect::new(u16::try_from(x).ok()?, u16::try_from(y).ok()?, width, 1);
        // A cell between words of one row keeps them apart.
        let wide = Rect::new(at.x.saturating_sub(1), at.y, width.saturating_add(2), 1);
        let inside = self.area.intersection(at) == at;
        (inside && !self.placed.iter().any(|other| other.at.intersects(wide))).then_some(at)
    }
}
