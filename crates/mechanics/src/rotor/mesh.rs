//! Nodes along a stepped shaft: at every end of a segment, at every station, and between them.

use super::{
    RotorError,
    element::{Material, ShaftElement, positive},
};

/// A piece of shaft as it is drawn: its diameters are linear from left to right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Length, m.
    pub length: f64,
    /// Outer diameters at the left and at the right, m.
    pub outer: [f64; 2],
    /// Inner diameters at the left and at the right, m.
    pub inner: [f64; 2],
    /// Material of the segment.
    pub material: Material,
}

/// Elements along a shaft, and where its stations have come to lie.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The elements, from left to right.
    pub elements: Vec<ShaftElement>,
    /// The node of every station, in the order they were given.
    pub stations: Vec<usize>,
}

/// Two places nearer to each other than this share of the length of the shaft are one.
const SAME: f64 = 1e-7;

/// Divides every stretch between neighbouring steps and stations into `count` equal elements.
///
/// Stations are distances from the left end, m.
///
/// # Errors
/// `Value` for a segment without length, or a station off the shaft.
pub fn mesh(segments: &[Segment], stations: &[f64], count: usize) -> Result<Mesh, RotorError> {
    let mut ends = vec![0.0];
    for segment in segments {
        positive("the length of a segment", segment.length)?;
        ends.push(ends.last().copied().unwrap_or(0.0) + segment.length);
    }
    let length = ends.last().copied().unwrap_or(0.0);
    positive("the length of the shaft", length)?;
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * length;
    let mut breaks = ends.clone();
    for &station in stations {
        if !(station >= -SAME * length && station <= length * (1.0 + SAME)) {
            return Err(RotorError::Value { what: "the place of a station off the shaft", value: station });
        }
        if !breaks.iter().any(|&here| near(here, station)) {
            breaks.push(station);
        }
    }
    breaks.sort_by(f64::total_cmp);

    let mut elements = Vec::new();
    let mut nodes = vec![(0.0, 0)];
    let mut current = 0;
    for stretch in breaks.windows(2) {
        let (from, to) = (stretch[0], stretch[1]);
        while current + 1 < segments.len() && ends[current + 1] <= from + SAME * length {
            current += 1;
        }
        let (segment, left) = (&segments[current], ends[current]);
        let step = (to - from) / count as f64;
        let at = |ends: [f64; 2], n: usize| {
            if ends[0] == ends[1] {
                return ends[0];
            }
            let share = (from + step * n as f64 - left) / segment.length;
            ends[0] + share.clamp(0.0, 1.0) * (ends[1] - ends[0])
        };
        elements.extend((0..count).map(|n| ShaftElement {
            length: step,
            outer: [at(segment.outer, n), at(segment.outer, n + 1)],
            inner: [at(segment.inner, n), at(segment.inner, n + 1)],
            material: segment.material,
        }));
        nodes.push((to, elements.len()));
    }
    let station =
        |&place: &f64| nodes.iter().find(|(here, _)| near(*here, place)).map_or(0, |(_, node)| *node);
    Ok(Mesh { elements, stations: stations.iter().map(station).collect() })
}
