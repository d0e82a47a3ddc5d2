//! `solver-script IN OUT`: a module of WebAssembly, with the functions by which JavaScript calls it, as one script.
//!
//! Text in a script is all that a page which is opened as a file can load. `SOLVER.module` is the module, compressed by gzip, in
//! base64; `SOLVER.bindings` is the source that declares `wasm_bindgen`.

use std::{env, fs, io::Write as _};

use anyhow::{Context as _, Result, bail};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use flate2::{Compression, write::GzEncoder};
use serde_json::json;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [input, output] = &arguments[..] else { bail!("write the module and the script") };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(input).no_modules(true)?.typescript(false);
    bindgen.remove_name_section(true).remove_producers_section(true);
    let mut made = bindgen.generate_output()?;
    let bindings = made.js().to_owned();
    let module = made.wasm_mut().emit_wasm();
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&module)?;
    let compressed = encoder.finish()?;
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
