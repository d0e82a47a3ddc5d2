//! A raster as Sixel. Its colours are a palette already: what `icy_sixel` brings, with some twenty crates, is to find one.
//!
//! Source: DEC, *VT330/VT340 Programmer Reference Manual*, volume 2, chapter 14 "Graphics Programming", sixel graphics.

use super::Raster;

/// Sixel of a raster on a ground: a pixel of no ink is left as it is.
pub(super) fn sixel(raster: &Raster, color: impl Fn(u8) -> [u8; 3]) -> Vec<u8> {
    let (width, height) = raster.size();
    // Squares for pixels, and what is not drawn stays.
    let mut bytes = format!("\x1bP0;1;0q\"1;1;{width};{height}").into_bytes();
    // A terminal may have few registers: degrees are taken four by four.
    let mut registers: Vec<u8> = Vec::new();
    let mut register_of = [None; 256];
    let rows: Vec<Vec<Option<usize>>> = (0..height)
        .map(|y| {
            raster
                .row(y)
                .iter()
                .map(|pixel| {
                    let coarse = coarse(raster, *pixel)?;
                    Some(*register_of[usize::from(coarse)].get_or_insert_with(|| {
                        registers.push(coarse);
                        registers.len() - 1
                    }))
                })
                .collect()
        })
        .collect();
    for (n, coarse) in registers.iter().enumerate() {
        let [red, green, blue] = color(*coarse).map(|part| (u32::from(part) * 100 + 127) / 255);
        bytes.extend(format!("#{n};2;{red};{green};{blue}").into_bytes());
    }
    for band in rows.chunks(6) {
        let mut used = vec![false; registers.len()];
        band.iter().flatten().flatten().for_each(|register| used[*register] = true);
        for (register, _) in used.iter().enumerate().filter(|(_, used)| **used) {
            bytes.extend(format!("#{register}").into_bytes());
            let bits = (0..width).map(|x| {
                let bit = |(n, row): (usize, &Vec<Option<usize>>)| u8::from(row[x] == Some(register)) << n;
                band.iter().enumerate().map(bit).sum::<u8>()
            });
            runs(bits, &mut bytes);
            bytes.push(b'$');
        }
        bytes.push(b'-');
    }
    bytes.extend(b"\x1b\\");
    bytes
}

/// The nearest of four degrees of the same ink; a pixel hardly covered is not.
fn coarse(raster: &Raster, pixel: u8) -> Option<u8> {
    let (_, degree) = raster.ink_of(pixel)?;
    let to = [0, 4, 8, 12, 15][usize::from((degree + 2) / 4).min(4)];
    (to > 0).then(|| pixel - degree + to)
}

/// Bits of columns, the last empty ones left out.
fn runs(bits: impl Iterator<Item = u8>, bytes: &mut Vec<u8>) {
    let mut run: (u8, usize) = (0, 0);
    let mut flush = |(bits, length): (u8, usize)| {
        let letter = bits + b'?';
        if length > 3 {
            bytes.extend(format!("!{length}").into_bytes());
            bytes.push(letter);
        } else {
            bytes.extend(std::iter::repeat_n(letter, length));
        }
    };
    for next in bits {
        if next == run.0 {
            run.1 += 1;
        } else {
            flush(run);
            run = (next, 1);
        }
    }
    if run.0 != 0 {
        flush(run);
    }
}
