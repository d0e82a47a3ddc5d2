//! Text of any encoding that data loggers and spreadsheet programs write.

use dalembert_core::Text;
use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// Bytes at the beginning in which UTF-16 without a mark is sought.
const SAMPLE: usize = 1024;

/// The text of a file: UTF-8; UTF-16, as Excel writes Unicode text, with or without its mark; otherwise Windows-1252, of
/// which Latin-1 is a part. Numbers and separators are the same bytes in any code page of the west, so that a wrong guess
/// among these can only spoil words; a unit that it spoils is refused as unknown. Lines that end in a carriage return alone,
/// as older programs of the Macintosh write them, end in a line feed here.
///
/// Error: the bytes are no text, but have control characters.
pub(crate) fn text(bytes: &[u8]) -> Result<String, Text> {
    let encoding = match Encoding::for_bom(bytes) {
        Some((encoding, _)) => encoding,
        None => unmarked(bytes),
    };
    let mut text = encoding.decode(bytes).0.into_owned();
    if text.contains('\r') && !text.contains('\n') {
        text = text.replace('\r', "\n");
    }
    // Form feeds and the mark at the end of old files are in texts, too.
    let is_binary =
        |c: char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{C}' | '\u{1A}') && c < '\u{80}';
    if text.contains(is_binary) {
        return Err("this is not a text file, nor a format that is read here".into());
    }
    Ok(text)
}

/// Encoding of bytes without a mark.
fn unmarked(bytes: &[u8]) -> &'static Encoding {
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let zeros = |odd: usize| sample.iter().skip(odd).step_by(2).filter(|byte| **byte == 0).count();
    // Digits and separators of UTF-16 have a zero byte each.
    let half = sample.len() / 4;
    match (zeros(0), zeros(1)) {
        (high, low) if high > half && low == 0 => UTF_16BE,
        (high, low) if low > half && high == 0 => UTF_16LE,
        _ if std::str::from_utf8(bytes).is_ok() => UTF_8,
        _ => WINDOWS_1252,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "t [s]\tx [µm]\n0\t1,5\n0,1\t−2,5\n";

    fn utf16(text: &str, bytes_of: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes_of).collect()
    }

    #[test]
    fn every_encoding_gives_the_same_text() {
        let marked = format!("\u{FEFF}{TABLE}");
        let text = |bytes: &[u8]| text(bytes).unwrap_or_else(|why| panic!("{}", why.english()));
        assert_eq!(text(TABLE.as_bytes()), TABLE);
        assert_eq!(text(marked.as_bytes()), TABLE);
        for bytes_of in [u16::to_le_bytes, u16::to_be_bytes] {
            assert_eq!(text(&utf16(&marked, bytes_of)), TABLE);
            assert_eq!(text(&utf16(TABLE, bytes_of)), TABLE);
        }
    }

    #[test]
    fn a_western_code_page_keeps_its_units() {
        assert_eq!(text(b"t [s];x [\xB5m];\xB0\n0;1,5;2\n"), Ok("t [s];x [µm];°\n0;1,5;2\n".to_owned()));
        // Code page 850 has another micro sign: the unit is spoilt, and will be unknown.
        assert_eq!(text(b"x [\xE6m]\n1,5\n"), Ok("x [æm]\n1,5\n".to_owned()));
    }

    #[test]
    fn lines_end_as_any_system_ends_them() {
        assert_eq!(text(b"t;x\r0;1\r"), Ok("t;x\n0;1\n".to_owned()));
        assert_eq!(text(b"t;x\r\n0;1\r\n"), Ok("t;x\r\n0;1\r\n".to_owned()));
    }

    #[test]
    fn what_is_no_text_is_refused() {
        for bytes in [&b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR"[..], b"1 2\n3 \x004\n", b"PK\x03\x04"] {
            assert!(text(bytes).is_err(), "{bytes:?}");
        }
    }
}
