//! The implementation of `Inputs` for a struct or an enum.

use proc_macro2::{Literal, TokenStream as Tokens};
use quote::format_ident;
use syn::{
    Data, DataEnum, DeriveInput, Error, Fields, FieldsNamed, Ident, Result, Type, Variant, Visibility,
};

use crate::field::{Arguments, FieldKind, documentation};

pub(crate) fn expand(item: &DeriveInput) -> Result<Tokens> {
    if !item.generics.params.is_empty() {
        return Err(Error::new_spanned(&item.generics, "inputs have no generic parameters"));
    }
    match &item.data {
        Data::Struct(data) => match &data.fields {
            Fields::Named(fields) => structure(item, fields),
            _ => Err(Error::new_spanned(item, "inputs have names: write a struct with named fields")),
        },
        Data::Enum(data) => alternatives(item, data),
        Data::Union(_) => Err(Error::new_spanned(item, "a union cannot be an input")),
    }
}

/// A list of fields as code.
struct Group {
    /// `Field { … }, …`
    described: Vec<Tokens>,
    names: Vec<Ident>,
    asks: Vec<FieldKind>,
    /// The symbols; of a nested struct or enum, the index of the symbols inside.
    symbols: Vec<String>,
}

impl Group {
    fn of(fields: &FieldsNamed) -> Result<Self> {
        let (mut described, mut names, mut all, mut symbols) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for field in &fields.named {
            let Some(ident) = &field.ident else {
                return Err(Error::new_spanned(field, "a field needs a name"));
            };
            let (label, help) = documentation(&field.attrs);
            if label.is_empty() {
                let why = "a field needs a line of documentation: it is the label in the form";
                return Err(Error::new_spanned(field, why));
            }
            let arguments = Arguments::of(&field.attrs)?;
            let asks = FieldKind::of(&field.ty, &arguments)?;
            let (name, symbol) = (ident.to_string(), arguments.symbol());
            let shape = asks.shape(&arguments)?;
            let (default, before) = (arguments.text("default"), arguments.text("default_before"));
            let kept_in = arguments.text("kept_in");
            let former = arguments.former()?;
            described.push(code! {
                dalembert_core::Field {
                    name: #name, label: #label, help: #help, symbol: #symbol, default: #default,
                    default_before: #before, kept_in: #kept_in, former: #former, shape: #shape,
                }
            });
            names.push(ident.clone());
            all.push(asks);
            symbols.push(symbol.to_owned());
        }
        Ok(Self { described, names, asks: all, symbols })
    }

    /// Fields of the lifted struct.
    fn given_fields(&self, visibility: &Tokens) -> Vec<Tokens> {
        let lifted = self.names.iter().zip(&self.asks).filter(|(_, asks)| asks.is_lifted());
        lifted
            .map(|(name, asks)| {
                let ty = asks.given_type();
                let doc = format!("`{name}` on the worksheet.");
                code! { #[doc = #doc] #visibility #name: #ty }
            })
            .collect()
    }

    /// `name: read, …`: `Option`s of all fields, from `value: &Value`.
    fn read(&self) -> Tokens {
        let names = &self.names;
        let reads = self.names.iter().zip(&self.asks).enumerate().map(|(at, (name, asks))| {
            let (text, at, read) = (name.to_string(), Literal::usize_unsuffixed(at), asks.read());
            if let Some(read) = asks.read_in_group(&at, &text) {
                return code! { let #name = #read; };
            }
            code! {
                let #name = {
                    let value = support::field(value, #at);
                    let field_path = &field_path.field(#text);
                    #read
                };
            }
        });
        code! { #(#reads)* let (#(Some(#names),)*) = (#(#names,)*) else { return None; }; }
    }

    /// `name: lifted, …`, from `#name: &T` in scope, `fields` and `lift`.
    fn given(&self) -> Vec<Tokens> {
        let lifted = self.names.iter().zip(&self.asks).enumerate().filter(|(_, (_, asks))| asks.is_lifted());
        lifted
            .map(|(at, (name, asks))| {
                if let Some(given) = asks.given_in_group(&Literal::usize_unsuffixed(at)) {
                    return code! { #name: { let this = #name; #given } };
                }
                let of = if asks.is_nested() { &self.symbols[at] } else { "" };
                let (text, at, given) = (name.to_string(), Literal::usize_unsuffixed(at), asks.given());
                code! {
                    #name: {
                        let this = #name;
                        let field = &fields[#at];
                        let field_path = lift.field_path.field_of(#text, #of);
                        let lift = dalembert_core::Lift {
                            sheet: lift.sheet,
                            value: lift.value.map(|value| support::field(value, #at)),
                            field_path: &field_path,
                        };
                        let _ = field;
                        #given
                    }
                }
            })
            .collect()
    }

    /// `0 => …, 1 => …,` from `#name: &mut T` in scope and `rest`.
    fn slots(&self) -> Vec<Tokens> {
        let all = self.names.iter().zip(&self.asks).enumerate();
        all.map(|(at, (name, asks))| {
            let (at, slot) = (Literal::usize_unsuffixed(at), asks.slot());
            code! { #at => { let this = #name; #slot } }
        })
        .collect()
    }
}

fn structure(item: &DeriveInput, fields: &FieldsNamed) -> Result<Tokens> {
    let (name, visibility) = (&item.ident, &item.vis);
    let given_name = format_ident!("{name}Given");
    let group = Group::of(fields)?;
    let (described, names) = (&group.described, &group.names);
    let given_fields = group.given_fields(&code! { pub });
    let (read, given, slots) = (group.read(), group.given(), group.slots());
    let doc = format!("The inputs of [`{name}`] as numbers of a worksheet.");
    Ok(code! {
        #[doc = #doc]
        #visibility struct #given_name<W: dalembert_core::Worksheet> {
            #(#given_fields,)*
            #[doc(hidden)]
            pub sheet: ::std::marker::PhantomData<W>,
        }

        const _: () = {
            use dalembert_core::derive_support as support;

            static FIELDS: &[dalembert_core::Field] = &[#(#described),*];

            impl dalembert_core::Inputs for #name {
                const SHAPE: dalembert_core::Shape = dalembert_core::Shape::Group(dalembert_core::Fields(&|| FIELDS));
                type Given<W: dalembert_core::Worksheet> = #given_name<W>;

                fn read(
                    value: &dalembert_core::Value,
                    field_path: &support::FieldPath<'_>,
                    errors: &mut ::std::vec::Vec<dalembert_core::FieldError>,
                ) -> ::std::option::Option<Self> {
                    #read
                    Some(Self { #(#names),* })
                }

                #[inline]
                fn given<W: dalembert_core::Worksheet>(&self, lift: dalembert_core::Lift<'_, W>) -> #given_name<W> {
                    let fields = FIELDS;
                    let Self { #(#names),* } = self;
                    let _ = (#(#names,)*);
                    #given_name { #(#given,)* sheet: ::std::marker::PhantomData }
                }

                #[inline]
                fn slot(&mut self, path: &[usize]) -> ::std::option::Option<&mut f64> {
                    let (first, rest) = path.split_first()?;
                    let Self { #(#names),* } = self;
                    match first { #(#slots)* _ => None }
                }
            }
        };
    })
}

/// The alternatives of an enum as code. Those of a flattened enum stand among its own: where an alternative stands among
/// all is then known at run time only.
#[derive(Default)]
struct Alternatives {
    statics: Vec<Tokens>,
    /// Expressions of `&[Variant]`; the own ones are one long.
    described: Vec<Tokens>,
    reads: Vec<Tokens>,
    givens: Vec<Tokens>,
    given_variants: Vec<Tokens>,
    slots: Vec<Tokens>,
    /// The own alternatives so far, and the flattened types.
    own: usize,
    flattened: Vec<Type>,
    /// Without a number in any alternative there is nothing to lift to the worksheet.
    lifts: bool,
}

impl Alternatives {
    /// The place of the next alternative.
    fn place(&self) -> Tokens {
        let (own, flattened) = (Literal::usize_unsuffixed(self.own), &self.flattened);
        code! { #own #(+ support::variants::<#flattened>().len())* }
    }

    fn flatten(&mut self, ident: &Ident, ty: &Type, given_name: &Ident) {
        let place = self.place();
        self.described.push(code! { support::variants::<#ty>() });
        self.reads.push(code! {
            if let Some(value) = support::flattened::<#ty>(value, #place) {
                return <#ty as dalembert_core::Inputs>::read(&value, field_path, errors).map(Self::#ident);
            }
        });
        let doc = format!("An alternative of [`{ident}`](Self::{ident}).");
        self.given_variants.push(code! {
            #[doc = #doc] #ident(<#ty as dalembert_core::Inputs>::Given<W>)
        });
        self.givens.push(code! {
            Self::#ident(this) => #given_name::#ident(dalembert_core::Inputs::given(this, lift)),
        });
        self.slots.push(
            code! { (first, Self::#ident(this)) => support::flattened_slot(this, first, #place, rest), },
        );
        self.flattened.push(ty.clone());
        self.lifts = true;
    }

    fn add(&mut self, variant: &Variant, given_name: &Ident) -> Result<()> {
        let (label, help) = documentation(&variant.attrs);
        if label.is_empty() {
            let why = "an alternative needs a line of documentation: it is the label in the form";
            return Err(Error::new_spanned(variant, why));
        }
        let empty = FieldsNamed {
            brace_token: syn::token::Brace::default(),
            named: syn::punctuated::Punctuated::new(),
        };
        let fields = match &variant.fields {
            Fields::Named(fields) => fields,
            Fields::Unit => &empty,
            Fields::Unnamed(_) => {
                let why = "the inputs of an alternative have names, but for `#[input(flatten)]` of one type";
                return Err(Error::new_spanned(variant, why));
            }
        };
        let group = Group::of(fields)?;
        let (ident, key) = (&variant.ident, kebab(&variant.ident.to_string()));
        let (list, inner) = (format_ident!("FIELDS_{}", self.own), &group.described);
        let former = Arguments::of(&variant.attrs)?.former()?;
        let place = self.place();
        self.own += 1;
        self.statics.push(code! { static #list: &[dalembert_core::Field] = &[#(#inner),*]; });
        self.described.push(code! {
            &[dalembert_core::Variant {
                name: #key, label: #label, help: #help, fields: dalembert_core::Fields(&|| #list), former: #former,
            }]
        });
        let (read, names, given, slot) = (group.read(), &group.names, group.given(), group.slots());
        let text = &key;
        self.reads.push(code! {
            if support::variant(value) == Some(#place) {
                let field_path = &field_path.field(#text);
                #read
                return Some(Self::#ident { #(#names),* });
            }
        });
        self.lifts |= !given.is_empty();
        let fields = group.given_fields(&code! {});
        let doc = format!("{label}.");
        self.given_variants.push(code! { #[doc = #doc] #ident { #(#fields,)* } });
        self.givens.push(code! {
            Self::#ident { #(#names),* } => {
                let fields = #list;
                let field_path = lift.field_path.field(#text);
                let lift = dalembert_core::Lift { field_path: &field_path, ..lift };
                let _ = (fields, lift.field_path, #(#names,)*);
                #given_name::#ident { #(#given,)* }
            }
        });
        self.slots.push(code! { (first, Self::#ident { #(#names),* }) if first == #place => {
            let (first, rest) = rest.split_first()?;
            let _ = (rest, #(&#names,)*);
            match first { #(#slot)* _ => None }
        } });
        Ok(())
    }
}

fn alternatives(item: &DeriveInput, data: &DataEnum) -> Result<Tokens> {
    let name = &item.ident;
    let visibility: &Visibility = &item.vis;
    let given_name = format_ident!("{name}Given");
    let mut all = Alternatives::default();
    for variant in &data.variants {
        match &variant.fields {
            Fields::Unnamed(fields)
                if fields.unnamed.len() == 1 && Arguments::of(&variant.attrs)?.has("flatten") =>
            {
                all.flatten(&variant.ident, &fields.unnamed[0].ty, &given_name);
            }
            _ => all.add(variant, &given_name)?,
        }
    }
    let Alternatives { statics, described, reads, givens, given_variants, slots, flattened, lifts, .. } = all;
    let variants = if flattened.is_empty() {
        code! {
            static VARIANTS: &[dalembert_core::Variant] = &[#((#described)[0]),*];
            fn variants() -> &'static [dalembert_core::Variant] { VARIANTS }
        }
    } else {
        code! {
            fn variants() -> &'static [dalembert_core::Variant] {
                static VARIANTS: ::std::sync::OnceLock<::std::vec::Vec<dalembert_core::Variant>> =
                    ::std::sync::OnceLock::new();
                let all: &[&[dalembert_core::Variant]] = &[#(#described),*];
                VARIANTS.get_or_init(|| all.concat())
            }
        }
    };
    let (given_type, given_item, given_body) = if lifts {
        let doc = format!("The inputs of [`{name}`] as numbers of a worksheet.");
        let item = code! {
            #[doc = #doc]
            #visibility enum #given_name<W: dalembert_core::Worksheet> { #(#given_variants,)* }
        };
        (code! { #given_name<W> }, item, code! { match self { #(#givens)* } })
    } else {
        (code! { () }, code! {}, code! { let _ = lift; })
    };
    Ok(code! {
        #given_item

        const _: () = {
            use dalembert_core::derive_support as support;

            #(#statics)*
            #variants

            impl dalembert_core::Inputs for #name {
                const SHAPE: dalembert_core::Shape = dalembert_core::Shape::OneOf(variants);
                type Given<W: dalembert_core::Worksheet> = #given_type;

                fn read(
                    value: &dalembert_core::Value,
                    field_path: &support::FieldPath<'_>,
                    errors: &mut ::std::vec::Vec<dalembert_core::FieldError>,
                ) -> ::std::option::Option<Self> {
                    #(#reads)*
                    support::one_of(field_path, errors)
                }

                #[inline]
                fn given<W: dalembert_core::Worksheet>(&self, lift: dalembert_core::Lift<'_, W>) -> #given_type {
                    #given_body
                }

                #[inline]
                fn slot(&mut self, path: &[usize]) -> ::std::option::Option<&mut f64> {
                    let (&first, rest) = path.split_first()?;
                    match (first, self) { #(#slots)* _ => None }
                }
            }
        };
    })
}

/// `SimplySupported` as `simply-supported`.
fn kebab(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !text.is_empty() {
            text.push('-');
        }
        text.extend(c.to_lowercase());
    }
    text
}
