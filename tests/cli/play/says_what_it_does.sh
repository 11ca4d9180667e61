rocinante play --help
