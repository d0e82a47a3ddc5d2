//! Recordings of sound and vibration in WAV files.

use std::io::Cursor;

use dalembert_core::{Text, study::DataColumn};
use hound::{Error, SampleFormat, WavReader};

use crate::{numbers, part::Part};

/// The longest recording, in samples of a channel.
const MOST_SAMPLES: u32 = 1 << 22;

/// Time and channels of a recording as the text of a table with so many columns. Times follow from the sample rate;
/// samples are shares of the full scale, which is 1, and have no unit.
///
/// `part` has the numbers of the channels, from 1; without any, all of them, where there are as many as columns.
///
/// Errors: what is not PCM of whole numbers or of 32-bit floating-point numbers; a channel that there is not; several
/// channels of which none is chosen; a recording that is too long.
pub(crate) fn table(bytes: &[u8], part: &Part, wanted: usize) -> Result<String, Text> {
    let mut reader = WavReader::new(Cursor::new(bytes)).map_err(unreadable)?;
    let spec = reader.spec();
    let channels = usize::from(spec.channels);
    if reader.duration() > MOST_SAMPLES {
        let why = Text::new("this recording has {have} samples; at most {most} are read: cut out the decay");
        return Err(why.with("have", reader.duration()).with("most", MOST_SAMPLES));
    }
    let chosen = match part.numbers()? {
        chosen if !chosen.is_empty() => chosen,
        _ if channels == 1 || channels + 1 == wanted => (1..=channels).collect(),
        _ => {
            let why = Text::new("this recording has {have} channels: choose one, as in `#1`");
            return Err(why.with("have", channels));
        }
    };
    if let Some(channel) = chosen.iter().find(|channel| **channel > channels) {
        let why = Text::new("there is no channel {channel}: this recording has {have}");
        return Err(why.with("channel", channel).with("have", channels));
    }
    let samples: Vec<f64> = match spec.sample_format {
        SampleFormat::Int => {
            let full_scale = 2f64.powi(i32::from(spec.bits_per_sample) - 1);
            let shares =
                reader.samples::<i32>().map(|sample| sample.map(|sample| f64::from(sample) / full_scale));
            shares.collect::<Result<_, _>>()
        }
        SampleFormat::Float => reader.samples::<f32>().map(|sample| sample.map(f64::from)).collect(),
    }
    .map_err(unreadable)?;
    let rate = f64::from(spec.sample_rate);
    let times = (0..samples.len() / channels.max(1)).map(|n| n as f64 / rate).collect();
    let mut columns = vec![DataColumn { name: "time".to_owned(), unit: "s".to_owned(), numbers: times }];
    columns.extend(chosen.iter().map(|channel| DataColumn {
        name: format!("channel {channel}"),
        unit: String::new(),
        numbers: samples.iter().skip(channel - 1).step_by(channels).copied().collect(),
    }));
    numbers::text(&columns)
}

/// The reason of the reader, with the kinds of samples that are read.
fn unreadable(error: Error) -> Text {
    let why = "this WAV file cannot be read ({why}): save it as PCM of 16, 24 or 32 bits, or as 32-bit floating-point numbers";
    Text::new(why).with("why", error)
}
