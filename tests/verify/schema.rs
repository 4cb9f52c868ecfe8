//! As much of JSON Schema as the published schemas use; a keyword that is not known here fails the test.

use serde_json::Value;

/// Where a value breaks its schema, and how; none if it does not.
pub fn violation(root: &Value, value: &Value) -> Option<String> {
    check(root, root, value, "$").err()
}

type Checked = Result<(), String>;

fn check(root: &Value, schema: &Value, value: &Value, place: &str) -> Checked {
    let schema = schema.as_object().expect("a schema is an object");
    for (keyword, argument) in schema {
        match keyword.as_str() {
            "$schema" | "$defs" | "title" | "description" => {}
            "$ref" => {
                let name = argument.as_str().and_then(|path| path.strip_prefix("#/$defs/")).expect("a definition");
                check(root, &root["$defs"][name], value, place)?;
            }
            "type" => {
                let types = argument.as_array().cloned().unwrap_or_else(|| vec![argument.clone()]);
                let is = types.iter().any(|name| is_of(value, name.as_str().expect("a type's name")));
                demand(is, place, || format!("{value} is not of type {argument}"))?;
            }
            "const" => demand(value == argument, place, || format!("{value} is not {argument}"))?,
            "enum" => {
                let is = argument.as_array().expect("values").contains(value);
                demand(is, place, || format!("{value} is none of {argument}"))?;
            }
            "minimum" => demand(value.as_f64() >= argument.as_f64(), place, || format!("{value} < {argument}"))?,
            "maximum" => demand(value.as_f64() <= argument.as_f64(), place, || format!("{value} > {argument}"))?,
            "minItems" => demand(length(value) >= argument.as_u64(), place, || "too few items".to_owned())?,
            "maxItems" => demand(length(value) <= argument.as_u64(), place, || "too many items".to_owned())?,
            "items" => {
                for (index, item) in value.as_array().into_iter().flatten().enumerate() {
                    check(root, argument, item, &format!("{place}[{index}]"))?;
                }
            }
            "required" => {
                for name in argument.as_array().expect("names") {
                    let is = value.get(name.as_str().expect("a name")).is_some();
                    demand(is, place, || format!("{name} is missing"))?;
                }
            }
            "properties" => {
                for (name, schema) in argument.as_object().expect("properties") {
                    if let Some(value) = value.get(name) {
                        check(root, schema, value, &format!("{place}.{name}"))?;
                    }
                }
            }
            "additionalProperties" => {
                for (name, value) in value.as_object().into_iter().flatten() {
                    let known = schema.get("properties").is_some_and(|known| known.get(name).is_some());
                    match argument {
                        _ if known => {}
                        Value::Bool(false) => return Err(format!("{place}: {name} is not known")),
                        schema => check(root, schema, value, &format!("{place}.{name}"))?,
                    }
                }
            }
            "oneOf" => {
                let schemas = argument.as_array().expect("schemas");
                let fits = schemas.iter().filter(|schema| check(root, schema, value, place).is_ok()).count();
                demand(fits == 1, place, || format!("{value} fits {fits} of the schemas, not one"))?;
            }
            "pattern" => {
                let text = value.as_str().unwrap_or_default();
                let is = fits(argument.as_str().expect("a pattern"), text);
                demand(is, place, || format!("{value} does not match {argument}"))?;
            }
            other => panic!("the keyword {other} of the schema is not known to the test"),
        }
    }
    Ok(())
}

fn demand(holds: bool, place: &str, otherwise: impl Fn() -> String) -> Checked {
    if holds { Ok(()) } else { Err(format!("{place}: {}", otherwise())) }
}

fn is_of(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "null" => value.is_null(),
        other => panic!("the type {other} of the schema is not known to the test"),
    }
}

fn length(value: &Value) -> Option<u64> {
    value.as_array().map(|items| items.len() as u64)
}

/// The patterns of the schema, each by hand.
fn fits(pattern: &str, text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let decimal = |text: &str| match text.split_once('.') {
        None => digits(text),
        Some((whole, fraction)) => digits(whole) && digits(fraction),
    };
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    match pattern {
        r"^-?[0-9]+(\.[0-9]+|/[0-9]+)?$" => match unsigned.split_once('/') {
            None => decimal(unsigned),
            Some((p, q)) => digits(p) && digits(q),
        },
        r"^(-?[0-9]+(\.[0-9]+)?(e-?[0-9]+)?|NaN|-?inf)$" => match unsigned.split_once('e') {
            None => decimal(unsigned) || unsigned == "inf" || text == "NaN",
            Some((mantissa, exponent)) => decimal(mantissa) && digits(exponent.strip_prefix('-').unwrap_or(exponent)),
        },
        r"^[0-9a-f]{64}$" => {
            text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte))
        }
        r"^-?[0-9]+(\.[0-9]+)?$" => decimal(unsigned),
        r"^TRC-[A-Z]+-[0-9]{2}$" => {
            let parts: Vec<&str> = text.split('-').collect();
            let [first, chapter, number] = parts[..] else { return false };
            let capital = !chapter.is_empty() && chapter.bytes().all(|byte| byte.is_ascii_uppercase());
            first == "TRC" && capital && number.len() == 2 && digits(number)
        }
        r"^[a-z0-9]+(-[a-z0-9]+)*$" => text.split('-').all(|part| {
            !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
        }),
        other => panic!("the pattern {other} of the schema is not known to the test"),
    }
}
