//! A certificate as an HTML page.

use minijinja::{Environment, context};

use super::statement::Certificate;

/// The certificate as one HTML page, without scripts.
///
/// # Errors
///
/// If the template fails, in words: a fault of the toolkit.
pub fn page(certificate: &Certificate) -> Result<String, String> {
    let mut environment = Environment::new();
    environment
        .add_template("certificate.html", include_str!("certificate.html"))
        .and_then(|()| environment.get_template("certificate.html"))
        .and_then(|template| {
            template.render(context! { certificate, style => include_str!("../report/page/report.css") })
        })
        .map_err(|error| format!("{error:#}"))
}
