//! `#[derive(Inputs)]`: the inputs of a problem, from its struct.

/// `quote!` whose local variables are its own: a field may be called `value` or `path`.
macro_rules! code {
    ($($tokens:tt)*) => { quote::quote_spanned!(proc_macro2::Span::mixed_site()=> $($tokens)*) };
}

mod expand;
mod field;

use proc_macro::TokenStream;

/// Describes a struct (or an enum of alternatives) to forms, files and the command line.
///
/// | type of the field | what a user sees |
/// |---|---|
/// | `f64` with `#[input("m", "kg", positive)]` | a quantity: symbol, unit, limits |
/// | `MeasuredQuantity` with `#[input("A", "um \| mm/s \| 1")]` | a quantity of one of several kinds, as the unit says that is written; in a problem all are of one |
/// | `Vector3<f64>` with `#[input("F", "N")]` | a vector; `planar` asks for two components |
/// | `String`, `bool` | a text, yes or no |
/// | `u32`, `u64`, `usize` with `#[input(min = 1, max = 20)]` | a whole number |
/// | `Reference` with `#[input(rows = "bodies")]` | the name of a row of the top-level list `bodies` |
/// | `Option<T>` | an input that may be left out |
/// | `Vec<T>` | rows: add, remove, reorder; `#[input(min = 1)]` asks for at least one, `most = 50` takes no more (else 1000) |
/// | `Vec<T>` with `#[input(table)]` | a table with columns, typed or pasted |
/// | another type that derives `Inputs` | its fields in place (struct), or a choice among its alternatives (enum); `#[input("A")]` gives the symbols inside an index: `r_A` |
///
/// An alternative `#[input(flatten)] Round(RoundSection)` stands for those of another enum, in its place: what several
/// choices have in common is written once.
///
/// Arguments of a quantity: `positive`, `nonnegative`, `fraction` (in per cent, but a number below one without a unit is
/// a fraction, as books print it), `grade` (a balance quality grade: `G 6.3` is read as 6.3), `above = x`,
/// `below = x`, `min = x`, `max = x` (in the unit of the field), `kind = "Amplitude"` where the unit does not tell the
/// kind, `default = "9.81 m/s^2"`,
/// `default_before = "…"` the default of files of the first format, where it was another;
/// `formerly = "displacement|velocity"` names the alternatives that stood here in earlier files, one for each kind of the
/// quantities in them;
/// `kept_in = "drawn"` names the optional field beside it that keeps its first value when it is changed alone. The
/// default of a choice is the name of an alternative: `default = "hoop"`; a choice without one must be made.
///
/// The first line of documentation is the label in the form, the rest its help. With the struct comes
/// `NameGiven<W>`: the same inputs as numbers of a worksheet. Texts, flags, counts, references and tables are not
/// in it; the struct itself has them.
#[proc_macro_derive(Inputs, attributes(input))]
pub fn inputs(item: TokenStream) -> TokenStream {
    let item = syn::parse_macro_input!(item as syn::DeriveInput);
    expand::expand(&item).unwrap_or_else(|err| err.to_compile_error()).into()
}
