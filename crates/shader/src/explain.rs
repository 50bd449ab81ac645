//! naga's validation errors in words: it names expressions and types by number, authors by their text.

use std::error::Error;

use naga::back::binary_operation_str;
use naga::front::Typifier;
use naga::proc::{ResolveContext, TypeResolution};
use naga::valid::{CallError, EntryPointError, ExpressionError, FunctionError, ValidationError};
use naga::{Block, Expression, Function, Handle, Module, Span, Statement};

use crate::words;

/// What is invalid: its kind, and its name if it has one.
pub(crate) fn subject(error: &ValidationError) -> (&'static str, Option<&str>) {
    match error {
        ValidationError::Type { name, .. } => ("type", Some(name)),
        ValidationError::Constant { name, .. } => ("constant", Some(name)),
        ValidationError::Override { name, .. } => ("override", Some(name)),
        ValidationError::GlobalVariable { name, .. } => ("variable", Some(name)),
        ValidationError::Function { name, .. } => ("function", Some(name)),
        ValidationError::EntryPoint { name, .. } => ("entry point", Some(name)),
        _ => ("module", None),
    }
}

/// Why it is invalid.
pub(crate) fn reason(module: &Module, error: &ValidationError) -> String {
    let known = in_function(module, error).and_then(|(function, source)| mistake(module, function, source));
    known.unwrap_or_else(|| {
        let mut deepest: &dyn Error = error;
        while let Some(source) = deepest.source() {
            deepest = source;
        }
        deepest.to_string()
    })
}

/// The statement that is invalid, where naga points at the declaration of what it uses instead.
pub(crate) fn statement(module: &Module, error: &ValidationError) -> Option<Span> {
    let (function, source) = in_function(module, error)?;
    match source {
        FunctionError::InvalidReturnType { expression: returned @ Some(_), .. } => {
            find(&function.body, &|it| matches!(it, Statement::Return { value } if value == returned))
        }
        FunctionError::InvalidStoreTypes { pointer: to, value: from } => find(
            &function.body,
            &|it| matches!(it, Statement::Store { pointer, value } if pointer == to && value == from),
        ),
        _ => None,
    }
}

fn find(block: &Block, wanted: &impl Fn(&Statement) -> bool) -> Option<Span> {
    block.span_iter().find_map(|(statement, span)| match statement {
        _ if wanted(statement) => Some(*span),
        Statement::Block(block) => find(block, wanted),
        Statement::If { accept, reject, .. } => find(accept, wanted).or_else(|| find(reject, wanted)),
        Statement::Switch { cases, .. } => cases.iter().find_map(|case| find(&case.body, wanted)),
        Statement::Loop { body, continuing, .. } => find(body, wanted).or_else(|| find(continuing, wanted)),
        _ => None,
    })
}

/// The invalid function, and why.
fn in_function<'a>(
    module: &'a Module,
    error: &'a ValidationError,
) -> Option<(&'a Function, &'a FunctionError)> {
    match error {
        ValidationError::Function { handle, source, .. } => Some((&module.functions[*handle], source)),
        ValidationError::EntryPoint { stage, name, source: EntryPointError::Function(source) } => {
            let entry = module.entry_points.iter().find(|entry| entry.stage == *stage && entry.name == *name);
            entry.map(|entry| (&entry.function, source))
        }
        _ => None,
    }
}

/// The mistakes that authors make most.
fn mistake(module: &Module, function: &Function, error: &FunctionError) -> Option<String> {
    let expression = |handle| type_of(module, function, handle);
    Some(match error {
        FunctionError::Expression {
            source: ExpressionError::InvalidBinaryOperandTypes { op, lhs_type, rhs_type, .. },
            ..
        } => {
            let (left, right) = (words::of_inner(module, lhs_type), words::of_inner(module, rhs_type));
            format!("`{}` cannot take {left} and {right}", binary_operation_str(*op))
        }
        FunctionError::InvalidReturnType { expression: returned, expected_ty } => {
            let declared = expected_ty.map_or_else(|| "nothing".into(), |ty| words::of_type(module, ty));
            match returned {
                Some(returned) => {
                    format!("returns {}, declared to return {declared}", expression(*returned)?)
                }
                None => format!("some path returns nothing, declared to return {declared}"),
            }
        }
        FunctionError::InvalidIfType(condition) => {
            format!("the condition is {}, must be bool", expression(*condition)?)
        }
        FunctionError::InvalidStorePointer(_) => "cannot be written to".into(),
        FunctionError::InvalidStoreTypes { pointer, value } => {
            format!("{} cannot be stored through {}", expression(*value)?, expression(*pointer)?)
        }
        FunctionError::InvalidCall {
            function: callee,
            error: CallError::ArgumentType { index, required, seen_expression },
        } => {
            let callee = module.functions[*callee].name.as_deref().unwrap_or_default();
            let (seen, required) = (expression(*seen_expression)?, words::of_type(module, *required));
            format!("argument {} of `{callee}` is {seen}, must be {required}", index + 1)
        }
        FunctionError::MissingCapability(missing)
        | FunctionError::Expression { source: ExpressionError::MissingCapabilities(missing), .. } => {
            let names: Vec<&str> = missing.iter_names().map(|(name, _)| name).collect();
            format!("needs an optional feature: {}", names.join(", "))
        }
        _ => return None,
    })
}

fn type_of(module: &Module, function: &Function, expression: Handle<Expression>) -> Option<String> {
    let context = ResolveContext::with_locals(module, &function.local_variables, &function.arguments);
    let mut typifier = Typifier::new();
    typifier.grow(expression, &function.expressions, &context).ok()?;
    Some(match &typifier[expression] {
        TypeResolution::Handle(ty) => words::of_type(module, *ty),
        TypeResolution::Value(inner) => words::of_inner(module, inner),
    })
}
