//! Analyses: family-title.

dalembert_core::messages!("../locales/pt-BR.ftl");
