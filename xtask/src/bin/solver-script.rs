//! `solver-script IN OUT TEXT...`: a module of WebAssembly, with the functions by which JavaScript calls it, as one script.
//!
//! The files TEXT, which the module includes and nothing in it reads, are blanked there: a page has its own case, and the
//! published ones would be a sixteenth of what is downloaded.
//!
//! Text in a script is all that a page which is opened as a file can load. `SOLVER.module` is the module, compressed by gzip, in
//! base64; `SOLVER.bindings` is the source that declares `wasm_bindgen`.

use std::{env, fs, num::NonZeroU64};

use anyhow::{Context as _, Result, bail};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use memchr::memmem;
use serde_json::json;
use wasm_bindgen_cli_support::Bindgen;
use zopfli::{Format, Options};

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [input, output, texts @ ..] = &arguments[..] else { bail!("write the module and the script") };
    let mut bindgen = Bindgen::new();
    let mut module = fs::read(input).with_context(|| format!("{input} cannot be read"))?;
    for text in texts {
        blank(&mut module, &fs::read(text)?).with_context(|| format!("{text} is not in the module"))?;
    }
    bindgen.input_bytes("solver", module).no_modules(true)?.typescript(false);
    bindgen.remove_name_section(true).remove_producers_section(true);
    let mut made = bindgen.generate_output()?;
    let bindings = made.js().to_owned();
    let module = made.wasm_mut().emit_wasm();
    // One pass of Zopfli is a twentieth less than Deflate at its best; more passes take minutes for another hundredth.
    let once = Options { iteration_count: NonZeroU64::MIN, ..Options::default() };
    let mut compressed = Vec::new();
    zopfli::compress(once, Format::Gzip, module.as_slice(), &mut compressed)?;
    let script = json!({ "bindings": bindings, "module": STANDARD.encode(&compressed) });
    fs::write(output, format!("const SOLVER = {script};\n"))
        .with_context(|| format!("{output} cannot be written"))?;
    println!(
        "solver: {:.2} MB of WebAssembly, {:.2} MB compressed by gzip",
        module.len() as f64 / 1e6,
        compressed.len() as f64 / 1e6
    );
    Ok(())
}

/// Writes zeros over a text in the data of a module; `None` where it is not there.
fn blank(module: &mut [u8], text: &[u8]) -> Option<()> {
    let at = memmem::find(module, text)?;
    module[at..at + text.len()].fill(0);
    Some(())
}
