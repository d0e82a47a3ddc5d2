//! A raster as PNG: one byte a pixel, with a palette of colours and how opaque each is.
//!
//! Four chunks of one kind of picture are written here: the crate `png` would bring four crates for them.
//!
//! Source: *Portable Network Graphics (PNG) Specification*, third edition, sections 5 and 11.

use std::io::{self, Write};

use flate2::{Compression, Crc, write::ZlibEncoder};

use super::{DEGREES, Raster};

/// Fast: runs of an empty ground are what there is to be found.
const LEVEL: u32 = 3;

/// PNG of a raster. `color` gives each pair of ink and degree its colour and opacity.
pub(super) fn png(raster: &Raster, color: impl Fn(u8) -> ([u8; 3], u8)) -> io::Result<Vec<u8>> {
    let (width, height) = raster.size();
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = [width as u32, height as u32].map(u32::to_be_bytes).concat();
    // Eight bits, a palette, and the only methods there are.
    header.extend([8, 3, 0, 0, 0]);
    chunk(*b"IHDR", &header, &mut bytes);
    let last = (DEGREES as usize * raster.inks.len()) as u8;
    let colors: Vec<([u8; 3], u8)> = (0..=last).map(color).collect();
    chunk(*b"PLTE", &colors.iter().flat_map(|(rgb, _)| *rgb).collect::<Vec<u8>>(), &mut bytes);
    chunk(*b"tRNS", &colors.iter().map(|(_, alpha)| *alpha).collect::<Vec<u8>>(), &mut bytes);
    let mut rows = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
    for y in 0..height {
        // Unfiltered: places in a palette are no amounts.
        rows.write_all(&[0])?;
        rows.write_all(raster.row(y))?;
    }
    chunk(*b"IDAT", &rows.finish()?, &mut bytes);
    chunk(*b"IEND", &[], &mut bytes);
    Ok(bytes)
}

fn chunk(name: [u8; 4], data: &[u8], bytes: &mut Vec<u8>) {
    let mut sum = Crc::new();
    sum.update(&name);
    sum.update(data);
    bytes.extend((data.len() as u32).to_be_bytes());
    bytes.extend(name);
    bytes.extend(data);
    bytes.extend(sum.sum().to_be_bytes());
}
