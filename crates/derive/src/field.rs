//! One field: its type, its documentation and its `#[input(…)]`, as code that describes, reads and lifts it.

use proc_macro2::{Literal, TokenStream as Tokens};
use syn::{
    Attribute, Error, Expr, ExprLit, GenericArgument, Lit, Meta, PathArguments, Result, Type,
    punctuated::Punctuated, spanned::Spanned,
};

/// Kind of a field, by its type.
pub(crate) enum FieldKind {
    Quantity,
    /// A quantity of one of several kinds: its measure.
    Measured(Tokens),
    Vector,
    Text,
    Flag,
    Count(Type),
    Reference,
    Optional(Box<FieldKind>),
    Rows(Box<FieldKind>),
    Table(Type),
    Nested(Type),
}

/// The arguments of `#[input(…)]`.
pub(crate) struct Arguments {
    texts: Vec<String>,
    words: Vec<String>,
    values: Vec<(String, Expr)>,
    span: Option<proc_macro2::Span>,
}

impl FieldKind {
    /// Kind of a field of this type with these arguments.
    pub(crate) fn of(ty: &Type, arguments: &Arguments) -> Result<Self> {
        let Type::Path(path) = ty else {
            return Err(Error::new_spanned(
                ty,
                "this type cannot be an input; see the table in the docs of `Inputs`",
            ));
        };
        let Some(last) = path.path.segments.last() else {
            return Err(Error::new_spanned(ty, "a type is needed"));
        };
        let inner = || match &last.arguments {
            PathArguments::AngleBracketed(args) => match args.args.first() {
                Some(GenericArgument::Type(inner)) => Ok(inner.clone()),
                _ => Err(Error::new_spanned(ty, "the type inside is missing")),
            },
            _ => Err(Error::new_spanned(ty, "the type inside is missing")),
        };
        Ok(match last.ident.to_string().as_str() {
            "f64" => FieldKind::Quantity,
            "MeasuredQuantity" => FieldKind::Measured(arguments.measures()?),
            "Vector3" => FieldKind::Vector,
            "String" => FieldKind::Text,
            "bool" => FieldKind::Flag,
            "u32" | "u64" | "usize" => FieldKind::Count(ty.clone()),
            "Reference" => FieldKind::Reference,
            "Option" => FieldKind::Optional(Box::new(FieldKind::of(&inner()?, arguments)?)),
            "Vec" if arguments.has("table") => FieldKind::Table(inner()?),
            "Vec" => FieldKind::Rows(Box::new(FieldKind::of(&inner()?, arguments)?)),
            _ => FieldKind::Nested(ty.clone()),
        })
    }

    /// Returns true if the field is part of `NameGiven`.
    pub(crate) fn is_lifted(&self) -> bool {
        match self {
            FieldKind::Quantity | FieldKind::Measured(_) | FieldKind::Vector | FieldKind::Nested(_) => true,
            FieldKind::Optional(inner) | FieldKind::Rows(inner) => inner.is_lifted(),
            FieldKind::Text
            | FieldKind::Flag
            | FieldKind::Count(_)
            | FieldKind::Reference
            | FieldKind::Table(_) => false,
        }
    }

    /// Returns true if its symbols are those of another type.
    pub(crate) fn is_nested(&self) -> bool {
        match self {
            FieldKind::Nested(_) => true,
            FieldKind::Optional(inner) | FieldKind::Rows(inner) => inner.is_nested(),
            _ => false,
        }
    }

    /// A `Shape`.
    pub(crate) fn shape(&self, arguments: &Arguments) -> Result<Tokens> {
        Ok(match self {
            FieldKind::Quantity => {
                let measure = arguments.measure()?;
                code! { dalembert_core::Shape::Quantity(#measure) }
            }
            FieldKind::Measured(measure) => code! { dalembert_core::Shape::Quantity(#measure) },
            FieldKind::Vector => {
                let measure = arguments.measure()?;
                let len: usize = if arguments.has("planar") { 2 } else { 3 };
                code! { dalembert_core::Shape::Vector(#measure, #len) }
            }
            FieldKind::Text => code! { dalembert_core::Shape::Text },
            FieldKind::Flag => code! { dalembert_core::Shape::Flag },
            FieldKind::Count(_) => {
                let min = arguments.value("min").map_or_else(|| code! { 0 }, |min| code! { #min });
                let max = arguments.value("max").map_or_else(|| code! { 1_000_000 }, |max| code! { #max });
                code! { dalembert_core::Shape::Count { min: #min, max: #max } }
            }
            FieldKind::Reference => {
                let rows = arguments.value("rows").ok_or_else(|| {
                    arguments.error("a reference names the list it points into: #[input(rows = \"bodies\")]")
                })?;
                code! { dalembert_core::Shape::Reference(#rows) }
            }
            FieldKind::Optional(inner) => {
                let inner = inner.shape(arguments)?;
                code! { dalembert_core::Shape::Optional(|| { const SHAPE: &dalembert_core::Shape = &#inner; SHAPE }) }
            }
            FieldKind::Rows(inner) => {
                let min = arguments.value("min").map_or_else(|| code! { 0 }, |min| code! { #min });
                let most = arguments.value("most").map_or_else(|| code! { 1_000 }, |most| code! { #most });
                let inner = inner.shape(arguments)?;
                code! {
                    dalembert_core::Shape::Rows {
                        item: || { const SHAPE: &dalembert_core::Shape = &#inner; SHAPE },
                        min: #min,
                        most: #most,
                    }
                }
            }
            FieldKind::Table(row) => code! {
                dalembert_core::Shape::Table(dalembert_core::Fields(&|| <#row as dalembert_core::Inputs>::SHAPE.fields(None)))
            },
            // Behind a function, so that a type may contain itself.
            FieldKind::Nested(ty) => code! { <#ty as dalembert_core::Inputs>::SHAPE },
        })
    }

    /// An expression of `Option<Self>`, from `value: &Value` and `field_path: &FieldPath`, noting faults in `errors`.
    pub(crate) fn read(&self) -> Tokens {
        match self {
            FieldKind::Quantity => code! { support::quantity(value, field_path, errors) },
            FieldKind::Measured(measure) => code! {
                { const MEASURE: dalembert_core::Measure = #measure; support::measured(value, MEASURE, field_path, errors) }
            },
            FieldKind::Vector => code! { support::vector(value, field_path, errors) },
            FieldKind::Text => code! { support::text(value, field_path, errors) },
            FieldKind::Flag => code! { support::flag(value, field_path, errors) },
            FieldKind::Count(ty) => code! {
                support::count(value, field_path, errors).and_then(|count| <#ty>::try_from(count).ok())
            },
            FieldKind::Reference => code! { support::reference(value, field_path, errors) },
            FieldKind::Optional(inner) => {
                let inner = inner.read();
                code! { support::optional(value, errors, |value, errors| #inner) }
            }
            FieldKind::Rows(inner) => {
                let inner = inner.read();
                code! { support::rows(value, field_path, errors, |value, field_path, errors| #inner) }
            }
            FieldKind::Table(row) => code! {
                support::table(value, field_path, errors, support::table_row::<#row>)
            },
            FieldKind::Nested(ty) => {
                code! { <#ty as dalembert_core::Inputs>::read(value, field_path, errors) }
            }
        }
    }

    /// The same of the field of a group, from its `value`, `field_path` and `errors`: by a function that is compiled once.
    pub(crate) fn read_in_group(&self, at: &Literal, name: &str) -> Option<Tokens> {
        let function = |asks: &FieldKind| match asks {
            FieldKind::Quantity => Some(code! { support::quantity }),
            FieldKind::Vector => Some(code! { support::vector }),
            FieldKind::Text => Some(code! { support::text }),
            FieldKind::Flag => Some(code! { support::flag }),
            FieldKind::Reference => Some(code! { support::reference }),
            FieldKind::Nested(ty) => Some(code! { <#ty as dalembert_core::Inputs>::read }),
            _ => None,
        };
        match self {
            FieldKind::Optional(inner) => {
                let read = function(inner)?;
                Some(code! { support::read_optional(value, #at, #name, field_path, errors, #read) })
            }
            asks => {
                let read = function(asks)?;
                Some(code! { support::read_field(value, #at, #name, field_path, errors, #read) })
            }
        }
    }

    /// The type in `NameGiven<W>`.
    pub(crate) fn given_type(&self) -> Tokens {
        match self {
            FieldKind::Quantity | FieldKind::Measured(_) => code! { W::Num },
            FieldKind::Vector => code! { W::Vec },
            FieldKind::Optional(inner) => {
                let inner = inner.given_type();
                code! { ::std::option::Option<#inner> }
            }
            FieldKind::Rows(inner) => {
                let inner = inner.given_type();
                code! { ::std::vec::Vec<#inner> }
            }
            FieldKind::Nested(ty) => code! { <#ty as dalembert_core::Inputs>::Given<W> },
            _ => code! { () },
        }
    }

    /// An expression of the lifted value, from `this: &T`, `lift: Lift<W>` and `field: &'static Field`.
    pub(crate) fn given(&self) -> Tokens {
        match self {
            FieldKind::Quantity => code! { support::given(lift, field, *this) },
            FieldKind::Measured(_) => code! { support::given(lift, field, this.si) },
            FieldKind::Vector => code! { support::given_vector(lift, field, *this) },
            FieldKind::Optional(inner) => {
                let inner = inner.given();
                code! { this.as_ref().map(|this| #inner) }
            }
            FieldKind::Rows(inner) => {
                let inner = inner.given();
                code! {
                    this.iter().enumerate().map(|(n, this)| {
                        let field_path = lift.field_path.row(n);
                        let lift = dalembert_core::Lift {
                            sheet: lift.sheet, value: support::row_value(lift.value, n), field_path: &field_path,
                        };
                        #inner
                    }).collect()
                }
            }
            FieldKind::Nested(_) => code! { dalembert_core::Inputs::given(this, lift) },
            _ => code! { () },
        }
    }

    /// The same for a number or a vector, perhaps an optional one, in the group of `lift`, whose fields are `fields`.
    pub(crate) fn given_in_group(&self, at: &Literal) -> Option<Tokens> {
        match self {
            FieldKind::Quantity => Some(code! { support::field_given(lift, fields, #at, *this) }),
            FieldKind::Measured(_) => Some(code! { support::field_given(lift, fields, #at, this.si) }),
            FieldKind::Vector => Some(code! { support::field_given_vector(lift, fields, #at, *this) }),
            FieldKind::Optional(inner) if matches!(**inner, FieldKind::Quantity | FieldKind::Vector) => {
                let inner = inner.given_in_group(at)?;
                Some(code! { this.as_ref().map(|this| #inner) })
            }
            _ => None,
        }
    }

    /// An expression of `Option<&mut f64>`, from `this: &mut T` and `rest: &[usize]`.
    pub(crate) fn slot(&self) -> Tokens {
        match self {
            FieldKind::Quantity => code! { if rest.is_empty() { Some(this) } else { None } },
            FieldKind::Measured(_) => code! { if rest.is_empty() { Some(&mut this.si) } else { None } },
            FieldKind::Vector => code! { if let [axis] = rest { this.get_mut(*axis) } else { None } },
            FieldKind::Optional(inner) => {
                let inner = inner.slot();
                code! { this.as_mut().and_then(|this| #inner) }
            }
            FieldKind::Rows(inner) => {
                let inner = inner.slot();
                code! {
                    rest.split_first().and_then(|(row, rest)| this.get_mut(*row).and_then(|this| #inner))
                }
            }
            FieldKind::Nested(_) => code! { dalembert_core::Inputs::slot(this, rest) },
            _ => code! { { let _ = (this, rest); None } },
        }
    }
}

impl Arguments {
    /// The arguments of all `#[input(…)]` of a field.
    pub(crate) fn of(attributes: &[Attribute]) -> Result<Self> {
        let mut found = Arguments { texts: Vec::new(), words: Vec::new(), values: Vec::new(), span: None };
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("input")) {
            found.span = Some(attribute.span());
            for argument in attribute.parse_args_with(Punctuated::<Expr, syn::Token![,]>::parse_terminated)? {
                match &argument {
                    Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => found.texts.push(text.value()),
                    Expr::Path(path) if path.path.get_ident().is_some() => {
                        let word = path.path.require_ident()?.to_string();
                        let known =
                            ["positive", "nonnegative", "fraction", "grade", "planar", "table", "flatten"];
                        if !known.contains(&word.as_str()) {
                            return Err(Error::new_spanned(
                                &argument,
                                format!("expected one of {}", known.join(", ")),
                            ));
                        }
                        found.words.push(word);
                    }
                    Expr::Assign(assign) => {
                        let Expr::Path(left) = &*assign.left else {
                            return Err(Error::new_spanned(&argument, "expected `name = value`"));
                        };
                        let name = left.path.require_ident()?.to_string();
                        let known = [
                            "above",
                            "below",
                            "min",
                            "max",
                            "most",
                            "kind",
                            "default",
                            "default_before",
                            "kept_in",
                            "formerly",
                            "rows",
                        ];
                        if !known.contains(&name.as_str()) {
                            return Err(Error::new_spanned(
                                &argument,
                                format!("expected one of {}", known.join(", ")),
                            ));
                        }
                        found.values.push((name, (*assign.right).clone()));
                    }
                    other => {
                        return Err(Error::new_spanned(other, "expected a text, a word or `name = value`"));
                    }
                }
            }
        }
        Ok(found)
    }

    pub(crate) fn has(&self, word: &str) -> bool {
        self.words.iter().any(|found| found == word)
    }

    fn value(&self, name: &str) -> Option<&Expr> {
        self.values.iter().find(|(found, _)| found == name).map(|(_, value)| value)
    }

    /// The symbol: the first text of a quantity or a vector.
    pub(crate) fn symbol(&self) -> &str {
        self.texts.first().map_or("", String::as_str)
    }

    /// `Option<&'static str>`
    pub(crate) fn text(&self, name: &str) -> Tokens {
        self.value(name).map_or_else(|| code! { None }, |text| code! { Some(#text) })
    }

    fn error(&self, message: &str) -> Error {
        Error::new(self.span.unwrap_or_else(proc_macro2::Span::call_site), message)
    }

    /// The former alternatives of a field or of an alternative: `&[&str]`.
    pub(crate) fn former(&self) -> Result<Tokens> {
        let names = self.words_of("formerly")?;
        Ok(code! { &[#(#names),*] })
    }

    /// Words between the bars of a text: `"a | b"`.
    fn words_of(&self, name: &str) -> Result<Vec<String>> {
        match self.value(name) {
            Some(Expr::Lit(ExprLit { lit: Lit::Str(text), .. })) => Ok(between_bars(&text.value())),
            Some(other) => Err(Error::new_spanned(other, "expected a text in quotes")),
            None => Ok(Vec::new()),
        }
    }

    fn measure(&self) -> Result<Tokens> {
        let [_, unit] = &self.texts[..] else {
            return Err(self.error("a quantity needs #[input(\"symbol\", \"unit\")]"));
        };
        self.measure_in(unit, self.words_of("kind")?.first(), &[])
    }

    /// The measure of a quantity of one of several kinds, whose units stand between bars, as do their kinds.
    fn measures(&self) -> Result<Tokens> {
        let units = self.texts.get(1).map(|units| between_bars(units)).unwrap_or_default();
        let ([first, others @ ..], kinds) = (&units[..], self.words_of("kind")?) else {
            return Err(self.error("a measured quantity needs #[input(\"symbol\", \"unit | unit | …\")]"));
        };
        if ![0, units.len()].contains(&kinds.len()) {
            return Err(self.error("write a kind for each unit, with bars between them"));
        }
        let others = others.iter().zip(1..).map(|(unit, at)| self.measure_in(unit, kinds.get(at), &[]));
        self.measure_in(first, kinds.first(), &others.collect::<Result<Vec<_>>>()?)
    }

    fn measure_in(&self, unit: &str, kind: Option<&String>, others: &[Tokens]) -> Result<Tokens> {
        let kind = match kind {
            Some(name) => {
                let name = syn::parse_str::<syn::Ident>(name)
                    .map_err(|_| self.error("expected the name of a kind"))?;
                code! { Some(dalembert_core::derive_support::Kind::#name) }
            }
            None => code! { None },
        };
        let limit = |including: &str, excluding: &str, word: Option<(&str, &str)>| {
            let value = |value: &Expr| code! { (#value) as f64 };
            if let Some(limit) = self.value(including) {
                let limit = value(limit);
                return code! { dalembert_core::FieldLimit::Including(#limit) };
            }
            if let Some(limit) = self.value(excluding) {
                let limit = value(limit);
                return code! { dalembert_core::FieldLimit::Excluding(#limit) };
            }
            match word {
                Some((excluding, _)) if self.has(excluding) => {
                    code! { dalembert_core::FieldLimit::Excluding(0.0) }
                }
                Some((_, including)) if self.has(including) => {
                    code! { dalembert_core::FieldLimit::Including(0.0) }
                }
                _ => code! { dalembert_core::FieldLimit::None },
            }
        };
        let min = limit("min", "above", Some(("positive", "nonnegative")));
        let max = limit("max", "below", None);
        let (fraction, grade) = (self.has("fraction"), self.has("grade"));
        Ok(code! {
            dalembert_core::Measure {
                unit: #unit, kind: #kind, min: #min, max: #max, others: &[#(#others),*],
                fraction: #fraction, grade: #grade
            }
        })
    }
}

fn between_bars(text: &str) -> Vec<String> {
    text.split('|').map(|word| word.trim().to_owned()).collect()
}

/// The label and the help: the first line of documentation, and the rest.
pub(crate) fn documentation(attributes: &[Attribute]) -> (String, String) {
    let mut lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    });
    let label = lines.next().unwrap_or_default().trim_end_matches('.').to_owned();
    (label, lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" "))
}
