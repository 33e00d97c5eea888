"""Proxies of document objects. Their module paths stand in saved files: never move them."""
