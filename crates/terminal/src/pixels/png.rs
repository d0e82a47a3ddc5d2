//! A raster as PNG: one byte a pixel, with a palette of colours and how opaque each is.
//!
//! Source: *Portable Network Graphics (PNG) Specification*, third edition, sections 5 and 11.

use miniz_oxide::deflate::compress_to_vec_zlib;

use super::{DEGREES, Raster};

/// Fast: runs of an empty ground are what there is to be found.
const LEVEL: u8 = 3;

/// PNG of a raster. `color` gives each pair of ink and degree its colour and opacity.
pub(super) fn png(raster: &Raster, color: impl Fn(u8) -> ([u8; 3], u8)) -> Vec<u8> {
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
    let mut rows = Vec::with_capacity((width + 1) * height);
    for y in 0..height {
        // Unfiltered: places in a palette are no amounts.
        rows.push(0);
        rows.extend_from_slice(raster.row(y));
    }
    chunk(*b"IDAT", &compress_to_vec_zlib(&rows, LEVEL), &mut bytes);
    chunk(*b"IEND", &[], &mut bytes);
    bytes
}

fn chunk(name: [u8; 4], data: &[u8], bytes: &mut Vec<u8>) {
    bytes.extend((data.len() as u32).to_be_bytes());
    let from = bytes.len();
    bytes.extend(name);
    bytes.extend(data);
    let sum = crc(&bytes[from..]);
    bytes.extend(sum.to_be_bytes());
}

/// The check sum of ISO 3309, bit by bit, four bits at a time.
fn crc(data: &[u8]) -> u32 {
    const TABLE: [u32; 16] = {
        let mut table = [0; 16];
        let mut n = 0;
        while n < 16 {
            let (mut value, mut bit) = (n as u32, 0);
            while bit < 4 {
                value = if value & 1 == 1 { 0xEDB8_8320 ^ (value >> 1) } else { value >> 1 };
                bit += 1;
            }
            table[n] = value;
            n += 1;
        }
        table
    };
    !data.iter().fold(!0, |sum: u32, byte| {
        let sum = sum ^ u32::from(*byte);
        let sum = TABLE[(sum & 15) as usize] ^ (sum >> 4);
        TABLE[(sum & 15) as usize] ^ (sum >> 4)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The check value of the algorithm, CRC-32/ISO-HDLC.
    #[test]
    fn the_check_sum_is_that_of_the_standard() {
        assert_eq!(crc(b"123456789"), 0xCBF4_3926);
        // The last chunk of every PNG.
        let mut bytes = Vec::new();
        chunk(*b"IEND", &[], &mut bytes);
        assert_eq!(bytes, [0, 0, 0, 0, b'I', b'E', b'N', b'D', 0xAE, 0x42, 0x60, 0x82]);
    }
}
